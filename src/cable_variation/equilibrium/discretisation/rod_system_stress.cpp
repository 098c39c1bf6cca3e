// The section forces and moments that the Hessian's geometric part is made of, when they are not simply those
// of the strains at hand.

#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

using element::kDofs;
using element::kFirstDof;
using element::kGauss;
using element::kGaussAt;
using element::kLanes;
using element::kNodes;

void RodSystem::predictStress(const NodalField& motion) {
  const element::Kernel& kernel = element::kernel();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element at = elementOf(i, e);
      auto& nodes = batches_[at.batch].scratch;
      for (int a = 0; a < kNodes; ++a) {
        const auto column = static_cast<Eigen::Index>(3 * e) + a;
        for (int k = 0; k < 6; ++k) nodes[kFirstDof[a] + k][at.lane] = motion.spans[i](k, column);
      }
    }
  }
  for (Batch& batch : batches_) kernel.predict(batch.input, batch.scratch, batch.input.stress);
}

void RodSystem::relaxStress() {
  for (Batch& batch : batches_) {
    auto& stress = batch.input.stress;
    std::fill(&stress[0][0][0], &stress[0][0][0] + element::kGauss * 6 * kLanes, 0.0);
  }
}

void RodSystem::holdStress() {
  const element::Kernel& kernel = element::kernel();
  for (Batch& batch : batches_) {
    std::fill(&batch.scratch[0][0], &batch.scratch[0][0] + kDofs * kLanes, 0.0);
    kernel.predict(batch.input, batch.scratch, batch.input.stress);
  }
}

void RodSystem::takeStress(const RodSystem& other) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const std::vector<double>& there = other.grid_[i];
    std::size_t source = 0;
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element to = elementOf(i, e);
      for (int g = 0; g < kGauss; ++g) {
        const double fraction = grid_[i][e] + kGaussAt[g] * (grid_[i][e + 1] - grid_[i][e]);
        while (source + 2 < there.size() && there[source + 1] <= fraction) ++source;
        const double xi = (fraction - there[source]) / (there[source + 1] - there[source]);
        const Element from = other.elementOf(i, source);
        const auto& stress = other.batches_[from.batch].input.stress;
        auto& mine = batches_[to.batch].input.stress;
        double weight[kGauss];  // of the parabola through the Gauss points
        for (int a = 0; a < kGauss; ++a) {
          weight[a] = 1.0;
          for (int b = 0; b < kGauss; ++b) {
            if (b != a) weight[a] *= (xi - kGaussAt[b]) / (kGaussAt[a] - kGaussAt[b]);
          }
        }
        for (int k = 0; k < 6; ++k) {
          double value = 0.0;
          for (int a = 0; a < kGauss; ++a) value += weight[a] * stress[a][k][from.lane];
          mine[g][k][to.lane] = value;
        }
      }
    }
  }
  // unused lanes repeat a used one
  Batch& last = batches_.back();
  for (int g = 0; g < kGauss; ++g) {
    for (auto& lanes : last.input.stress[g]) {
      std::fill(lanes + last.lanes, lanes + kLanes, lanes[last.lanes - 1]);
    }
  }
}

}  // namespace cable_variation
