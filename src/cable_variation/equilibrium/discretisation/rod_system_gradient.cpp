#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

using element::kDofs;
using element::kInner;

void RodSystem::assembleArcLength() {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    data.slide_gradient.setZero();
    data.slide_second.setZero();
    if (!data.role.slides) continue;
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      Batch& batch = batches_[at.batch];
      // rows: the element's ends; columns: the span's stations
      Eigen::Matrix2d map;
      map << 1.0 - grid_[i][e], grid_[i][e], 1.0 - grid_[i][e + 1], grid_[i][e + 1];
      Eigen::Matrix2d second;
      const auto& s = batch.arc_length.second;
      second << s[0][at.lane], s[1][at.lane], s[1][at.lane], s[2][at.lane];
      data.slide_second += map.transpose() * second * map;
      data.slide_gradient += map.transpose() * Eigen::Vector2d(batch.arc_length.gradient[0][at.lane],
                                                               batch.arc_length.gradient[1][at.lane]);
      for (int side = 0; side < 2; ++side) {
        for (int k = 0; k < kDofs; ++k) {
          batch.slide[side][k][at.lane] = map(0, side) * batch.arc_length.mixed[0][k][at.lane] +
                                          map(1, side) * batch.arc_length.mixed[1][k][at.lane];
        }
      }
    }
  }
}

void RodSystem::assembleGradient(const Configuration& configuration) {
  if (has_slides_) assembleArcLength();
  gradient_.unknowns.setZero();
  effects_ = unknowns_.effects(configuration);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const SpanData& data = spans_[i];
    auto& nodes = gradient_.spans[i];
    nodes.setZero();
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      const auto& g = batches_[at.batch].energy.gradient;
      const auto first = static_cast<Eigen::Index>(3 * e);
      for (int k = 0; k < 6; ++k) {
        nodes(k, first) += g[kInner + k][at.lane];
        nodes(k, first + 1) = g[k][at.lane];
        nodes(k, first + 2) = g[6 + k][at.lane];
        nodes(k, first + 3) += g[kInner + 6 + k][at.lane];
      }
    }
    end_force_[i] = {nodes.col(0), nodes.col(nodes.cols() - 1)};
    Vector14d ends = Vector14d::Zero();
    ends.head<6>() = nodes.col(0);
    ends.segment<6>(6) = nodes.col(nodes.cols() - 1);
    if (data.role.slides) ends.tail<2>() = data.slide_gradient;
    addToUnknowns(i, ends, gradient_.unknowns);
    nodes.col(0).setZero();
    nodes.col(nodes.cols() - 1).setZero();
  }
  dead_moment_.assign(topology_.stations.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < topology_.stations.size(); ++i) {
    for (std::size_t index : topology_.stations[i].loads) {
      const PointLoad& load = harness_.loads[index];
      const Pose& pose = configuration.stations[i].pose;
      energy_.loads -= load.force.dot(pose.position);
      dead_moment_[i] += pose.orientation.conjugate() * load.moment;
      for (const UnknownEffect& effect : effects_[i]) {
        gradient_.unknowns[effect.unknown] -= load.force.dot(effect.displacement);
      }
    }
    for (const UnknownEffect& effect : effects_[i]) {
      gradient_.unknowns[effect.unknown] -= dead_moment_[i].dot(effect.rotation);
    }
  }
  energy_.springs = unknowns_.springEnergy(configuration);
  curvature_.clear();
  unknowns_.addSprings(configuration, gradient_.unknowns, &curvature_);

  std::vector<Eigen::Vector3d> moment(topology_.stations.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    moment[topology_.spans[i].left] += end_force_[i][0].tail<3>();
    moment[topology_.spans[i].right] += end_force_[i][1].tail<3>();
  }
  for (std::size_t i = 0; i < moment.size(); ++i) moment[i] -= dead_moment_[i];
  unknowns_.addCurvature(configuration, effects_, std::move(moment), curvature_);
}

void RodSystem::addToUnknowns(std::size_t span, const Vector14d& force, Eigen::VectorXd& unknowns) const {
  const Span& of = topology_.spans[span];
  for (int end = 0; end < 2; ++end) {
    const std::size_t station = end == 0 ? of.left : of.right;
    const Eigen::Vector3d along = force.segment<3>(6 * end);
    const Eigen::Vector3d about = force.segment<3>(6 * end + 3);
    for (const UnknownEffect& effect : effects_[station]) {
      unknowns[effect.unknown] += along.dot(effect.displacement) + about.dot(effect.rotation);
    }
    const int slide = unknowns_.slide(station);
    if (slide >= 0) unknowns[slide] += force[12 + end];
  }
}

double RodSystem::residual(std::size_t span) const {
  const auto& nodes = gradient_.spans[span];
  return std::max(nodes.topRows<3>().cwiseAbs().maxCoeff(),
                  nodes.bottomRows<3>().cwiseAbs().maxCoeff() / spans_[span].gyration);
}

double RodSystem::gyration(std::size_t span) const { return spans_[span].gyration; }

double RodSystem::bendingStiffness(std::size_t span) const { return spans_[span].bending_stiffness; }

double RodSystem::residual() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    largest = std::max(largest, residual(i));
  }
  for (std::size_t i = 0; i < topology_.stations.size(); ++i) {
    const std::size_t cable = topology_.stations[i].cable;
    const double gyration = spans_[topology_.cable_spans[cable].front()].gyration;
    const int slide = unknowns_.slide(i);
    if (slide >= 0) largest = std::max(largest, std::abs(gradient_.unknowns[slide]));
    for (const UnknownEffect& effect : effects_[i]) {
      const double force = std::abs(gradient_.unknowns[effect.unknown]);
      largest = std::max(largest, effect.displacement.isZero(0.0) ? force / gyration : force);
    }
  }
  return largest;
}

std::size_t RodSystem::worstSpan() const {
  std::size_t worst = 0;
  double largest = -1.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const double here = residual(i);
    if (here > largest) {
      largest = here;
      worst = i;
    }
  }
  return worst;
}

double RodSystem::residualNoise() const {
  double noise = 0.0;
  for (const SpanData& data : spans_) {
    // strains are differences of positions over an element; moments grow with the element count
    const double count = static_cast<double>(data.elements);
    const double moment = data.bending_stiffness * count / data.length() * count / data.gyration;
    const double far = reach_ * count / data.length();  // of the origin, over an element
    noise = std::max(noise, 1e-15 * (10.0 * data.stretch_stiffness * (1.0 + count + far) + 20.0 * moment));
  }
  return noise;
}

double RodSystem::stiffnessNoise() const {
  constexpr double kRounding = 1e-16;
  double noise = 0.0;
  for (const SpanData& data : spans_) {
    const double slenderness = data.length() / data.gyration;
    const double far = reach_ / data.length();
    noise = std::max(
        noise, kRounding * static_cast<double>(data.elements) * (1.0 + far) * slenderness * slenderness);
  }
  return noise;
}

bool RodSystem::slender() const {
  constexpr double kSlender = 1e3;  // length over the radius of gyration
  return std::any_of(spans_.begin(), spans_.end(),
                     [&](const SpanData& data) { return data.length() > kSlender * data.gyration; });
}

}  // namespace cable_variation
