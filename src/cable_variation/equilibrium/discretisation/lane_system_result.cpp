// What a lane's shape is, as for a harness of its own.

#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/discretisation.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/discretisation/lane_system_impl.h>

namespace cable_variation {

using element::kDofs;
using element::kInner;
using element::kNodeDofs;
using element::kNodes;

namespace {

int packed(int row, int column) { return row * (row + 1) / 2 + column; }

}  // namespace

Vector6d LaneSystem::endForce(std::size_t span, int end, int lane) const {
  const std::size_t last = spans_[span].count - 1;
  const auto& gradient = elements_[spans_[span].first_element + (end == 0 ? 0 : last)].energy.gradient;
  Vector6d force;
  for (int k = 0; k < kNodeDofs; ++k) force[k] = gradient[kInner + kNodeDofs * end + k][lane];
  return force;
}

Vector6d LaneSystem::sectionForce(std::size_t span, std::size_t boundary, int lane) const {
  if (boundary == 0) return -endForce(span, 0, lane);
  const auto& gradient = elements_[spans_[span].first_element + boundary - 1].energy.gradient;
  Vector6d force;
  for (int k = 0; k < kNodeDofs; ++k) force[k] = gradient[kInner + kNodeDofs + k][lane];
  return force;
}

Pose LaneSystem::pose(std::size_t span, std::size_t boundary, int lane) const {
  const bool last = boundary == spans_[span].count;
  const element::Input& input = elements_[spans_[span].first_element + boundary - (last ? 1 : 0)].input;
  const int node = last ? kNodes - 1 : 0;
  const auto& q = input.quaternion[node];
  const auto& p = input.position[node];
  return {{p[0][lane], p[1][lane], p[2][lane]}, {q[0][lane], q[1][lane], q[2][lane], q[3][lane]}};
}

double LaneSystem::largestStretch(int lane) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (std::size_t boundary = 0; boundary <= spans_[i].count; ++boundary) {
      const std::size_t e = boundary == 0 ? 0 : boundary - 1;
      const int gauss = boundary == 0 ? 0 : element::kGauss - 1;
      const double stiffness = elements_[spans_[i].first_element + e].input.stiffness[gauss][0][lane];
      const Vector6d force = sectionForce(i, boundary, lane);
      const Eigen::Vector3d normal = pose(i, boundary, lane).orientation * Eigen::Vector3d::UnitX();
      largest = std::max(largest, std::abs(normal.dot(force.head<3>())) / stiffness);
    }
  }
  return largest;
}

LaneSystem::Lanes LaneSystem::forceErrors(const LaneSystem& fine) const {
  Lanes errors{};
  for (std::size_t c = 0; c < problem_.topology.cable_spans.size(); ++c) {
    const ForceChange change = forceChange(fine, problem_.topology.cable_spans[c]);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double length = lanes_[lane]->harness.cables[c].length;
      errors[lane] = std::max(errors[lane], forceError(change, length, lane));
    }
  }
  return errors;
}

LaneSystem::ForceChange LaneSystem::forceChange(const LaneSystem& fine,
                                                const std::vector<std::size_t>& spans) const {
  ForceChange change;
  const auto raise = [](const double(*rows)[kLanes], int count, double* largest) {
    for (int lane = 0; lane < kLanes; ++lane) {
      double square = 0.0;
      for (int k = 0; k < count; ++k) square += rows[k][lane] * rows[k][lane];
      largest[lane] = std::max(largest[lane], square);
    }
  };
  for (const std::size_t i : spans) {
    const SpanLanes &of_fine = fine.spans_[i], &span = spans_[i];
    for (std::size_t e = 0; e < of_fine.count; ++e) {
      const auto& gradient = fine.elements_[of_fine.first_element + e].energy.gradient;
      for (int end = e == 0 ? 0 : 1; end < 2; ++end) {
        raise(gradient + kInner + kNodeDofs * end, 3, change.largest_force);
        raise(gradient + kInner + kNodeDofs * end + 3, 3, change.largest_moment);
      }
    }
    for (std::size_t e = 0; e < span.count; ++e) {
      const Element& at = elements_[span.first_element + e];
      for (const auto& stiffness : at.input.stiffness) {
        for (int lane = 0; lane < kLanes; ++lane)
          change.softest[lane] = std::min({change.softest[lane], stiffness[4][lane], stiffness[5][lane]});
      }
      for (const int first : element::kFirstDof) raise(at.rows + first + 4, 2, change.tilt);
    }
    for (int end = 0; end < 2; ++end) {
      const Element& at = elements_[span.first_element + (end == 0 ? 0 : span.count - 1)];
      const Element& before = fine.elements_[of_fine.first_element + (end == 0 ? 0 : of_fine.count - 1)];
      alignas(64) double after[kNodeDofs][kLanes];
      forceAfter(at, end, after);
      for (int k = 0; k < kNodeDofs; ++k) {
        for (int lane = 0; lane < kLanes; ++lane)
          after[k][lane] -= before.energy.gradient[kInner + kNodeDofs * end + k][lane];
      }
      raise(after, 3, change.force);
      raise(after + 3, 3, change.moment);
    }
  }
  return change;
}

// The force at an element's left (0) or right (1) end after the motion in its rows, as
// RodSystem::endForceAfter().
void LaneSystem::forceAfter(const Element& at, int end, double (*after)[kLanes]) {
  alignas(64) double force[kDofs][kLanes] = {};
  for (int k = 0; k < kInner; ++k) {
    for (int lane = 0; lane < kLanes; ++lane) force[k][lane] = -at.energy.gradient[k][lane];
  }
  element::kernel().condense(at.factor, force);
  for (int r = 0; r < kNodeDofs; ++r) {
    const int row = kInner + kNodeDofs * end + r;
    for (int lane = 0; lane < kLanes; ++lane)
      after[r][lane] = at.energy.gradient[row][lane] - force[row][lane];
    for (int c = kInner; c < kDofs; ++c) {
      const double* stiffness = at.factor.matrix[row >= c ? packed(row, c) : packed(c, row)];
      for (int lane = 0; lane < kLanes; ++lane) after[r][lane] += stiffness[lane] * at.rows[c][lane];
    }
  }
}

// As that of two RodSystems (discretisation.cpp).
double LaneSystem::forceError(const ForceChange& change, double length, std::size_t lane) {
  const double least = negligibleMoment(change.softest[lane], length);
  return std::max(
      {endForceError(std::sqrt(change.force[lane]), std::sqrt(change.largest_force[lane]), least / length),
       endForceError(std::sqrt(change.moment[lane]), std::sqrt(change.largest_moment[lane]), least),
       errorOfFiner(std::sqrt(change.tilt[lane]), 1.0) / kDirections});
}

void LaneSystem::read(int lane, Configuration& configuration) const {
  configuration.stations = lanes_[static_cast<std::size_t>(lane)]->configuration.stations;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanConfiguration& span = configuration.spans[i];
    for (std::size_t e = 0; e < spans_[i].count; ++e) {
      const element::Input& input = elements_[spans_[i].first_element + e].input;
      for (int node = 0; node < kNodes; ++node) {
        const std::size_t at = (kNodes - 1) * e + static_cast<std::size_t>(node);
        const auto& p = input.position[node];
        const auto& q = input.quaternion[node];
        span.positions[at] = {p[0][lane], p[1][lane], p[2][lane]};
        const Pose pose{span.positions[at], {q[0][lane], q[1][lane], q[2][lane], q[3][lane]}};
        span.orientations[at] = pose.orientation;
      }
    }
  }
}

void LaneSystem::describe(int index, Equilibrium& result) const {
  const Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  const Topology& topology = problem_.topology;
  result.energy = {};
  for (const Element& element : elements_) {
    result.energy.elastic += element.energy.elastic[index];
    result.energy.gravity += element.energy.load[index];
  }
  result.energy.springs = lane.unknowns.springEnergy(lane.configuration);
  for (std::size_t i = 0; i < topology.stations.size(); ++i) {
    for (std::size_t load : topology.stations[i].loads) {
      result.energy.loads -= lane.harness.loads[load].force.dot(lane.configuration.stations[i].pose.position);
    }
  }
  result.residual = residual_[static_cast<std::size_t>(index)];
  result.shapes.clear();
  for (std::size_t c = 0; c < lane.harness.cables.size(); ++c) {
    result.shapes.push_back(
        describeCable(lane.harness, topology, problem_.system->grid(), lane.configuration.stations, c,
                      [&](std::size_t span, std::size_t boundary) -> Boundary {
                        return {pose(span, boundary, index), sectionForce(span, boundary, index)};
                      }));
  }
  std::vector<std::array<Vector6d, 2>> end_force;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    end_force.push_back({endForce(i, 0, index), endForce(i, 1, index)});
  }
  describeReactions(lane.harness, topology, lane.configuration.stations, end_force, result);
}

}  // namespace cable_variation
