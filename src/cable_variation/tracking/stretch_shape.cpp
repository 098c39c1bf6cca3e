#include <cable_variation/tracking/stretch_shape.h>

#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

// Weights of the six points of a Bézier curve, at thirds of it.
constexpr double kThirds[4][6] = {{1, 0, 0, 0, 0, 0},
                                  {32.0 / 243, 80.0 / 243, 80.0 / 243, 40.0 / 243, 10.0 / 243, 1.0 / 243},
                                  {1.0 / 243, 10.0 / 243, 40.0 / 243, 80.0 / 243, 80.0 / 243, 32.0 / 243},
                                  {0, 0, 0, 0, 0, 1}};

// A frame's rate in a design rate; none: it stands still.
FrameRate rateOf(const DesignRate& rate, std::size_t component) {
  for (const auto& [index, frame] : rate.components) {
    if (index == component) return frame;
  }
  return {};
}

}  // namespace

LargestDistance largestDistance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  LargestDistance largest;
  largest.distance = std::sqrt((a - b).colwise().squaredNorm().maxCoeff(&largest.column));
  return largest;
}

std::vector<Eigen::Vector3d> StretchShape::centreline(std::size_t frame, std::size_t stretch) const {
  const std::vector<Eigen::Vector3d>& points = control[frame][stretch];
  std::vector<Eigen::Vector3d> line;
  line.reserve(points.size() * 4 / 6);
  for (std::size_t first = 0; first < points.size(); first += 6) {
    for (const auto& weights : kThirds) {
      line.emplace_back(Eigen::Vector3d::Zero());
      for (std::size_t i = 0; i < 6; ++i) line.back() += weights[i] * points[first + i];
    }
  }
  return line;
}

Eigen::Matrix3Xd StretchShape::predicted(const Eigen::VectorXd& change) const {
  Eigen::Matrix3Xd there = ends[0];
  for (Eigen::Index end = 0; end < there.cols(); ++end) {
    there.col(end) +=
        endRates(0, static_cast<std::size_t>(end), change.size()).topRows<3>().cast<double>() * change;
  }
  return there;
}

StretchShape StretchReader::read(const SamplePlace& place, const Equilibrium& equilibrium,
                                 const std::vector<CableView>& views,
                                 const ComponentPoses& components) const {
  std::vector<StationIntervals> intervals(views.begin(), views.end());
  StretchShape shape;
  shape.place = place;
  shape.discretisation_error = equilibrium.discretisation_error;
  const std::size_t count = stretches_->size();
  std::vector<std::vector<Eigen::Vector3d>> control(count);
  Eigen::Matrix3Xd ends(3, 2 * static_cast<Eigen::Index>(count));
  shape.radius.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const MaterialStretch& stretch = (*stretches_)[i];
    const StationIntervals& cable = intervals[stretch.cable];
    if (stretch.interval >= cable.size()) throw OtherStations();
    control[i].reserve(12);
    cable.appendControlPoints(stretch, control[i]);
    shape.radius.push_back(cable.largestRadius(stretch));
    ends.col(2 * static_cast<Eigen::Index>(i)) = control[i].front();
    ends.col(2 * static_cast<Eigen::Index>(i) + 1) = control[i].back();
  }
  for (const std::string& frame : *frames_) {
    if (frame == "world") {
      shape.control.push_back(control);
      shape.ends.push_back(ends);
      continue;
    }
    const Pose to_frame = poseIn(components, frame).inverse();
    shape.control.push_back(control);
    for (auto& points : shape.control.back()) {
      for (Eigen::Vector3d& point : points) point = to_frame * point;
    }
    shape.ends.push_back((to_frame.orientation.toRotationMatrix() * ends).colwise() + to_frame.position);
  }
  return shape;
}

StretchShape StretchReader::read(const SamplePlace& place, const Harness& harness,
                                 const Equilibrium& equilibrium) const {
  const bool from_world_only = frames_->size() == 1;
  return read(place, equilibrium, viewsOf(harness, equilibrium),
              from_world_only ? ComponentPoses() : space_->components(place));
}

StretchShape StretchReader::readWithRates(const SamplePlace& place, const Harness& harness,
                                          const Equilibrium& equilibrium, EquilibriumSolver& solver) const {
  const std::vector<CableView> cables = viewsOf(harness, equilibrium);
  const ComponentPoses components = space_->components(place);
  StretchShape shape = read(place, equilibrium, cables, components);
  const std::vector<DesignRate> design = space_->rates(place);
  std::vector<HarnessRate> harness_rates;
  harness_rates.reserve(design.size());
  for (const DesignRate& rate : design) harness_rates.push_back(rate.harness);
  const std::vector<EquilibriumRate> rates = solver.differentiate(harness_rates);
  const auto coordinates = static_cast<Eigen::Index>(rates.size());

  std::vector<StationIntervals> intervals(cables.begin(), cables.end());
  Eigen::Matrix4Xd world(4, 2 * static_cast<Eigen::Index>(stretches_->size()) * coordinates);
  Eigen::Index column = 0;
  for (const MaterialStretch& stretch : *stretches_) {
    for (const double share : {stretch.from, stretch.to}) {
      const Place at = intervals[stretch.cable].at(stretch.interval, share);
      for (std::size_t k = 0; k < rates.size(); ++k) {
        CableRate own;
        own.cable = stretch.cable;
        for (const CableRate& rate : harness_rates[k].cables) {
          if (rate.cable == stretch.cable) own = rate;
        }
        const PlaceRate rate = cables[stretch.cable].rate(at, {rates[k].shapes[stretch.cable], own});
        world.col(column++) << rate.position, rate.radius;
      }
    }
  }
  for (std::size_t frame = 0; frame < frames_->size(); ++frame) {
    if ((*frames_)[frame] == "world") {
      shape.rates.push_back(world.cast<float>());
      continue;
    }
    const Pose& pose = components.at((*frames_)[frame]);
    const std::size_t component = componentIndex(space_->scene(), (*frames_)[frame]);
    const Eigen::Matrix3d to_frame = pose.orientation.conjugate().toRotationMatrix();
    std::vector<FrameRate> carried;
    carried.reserve(design.size());
    for (const DesignRate& rate : design) carried.push_back(rateOf(rate, component));
    Eigen::Matrix4Xd seen = world;
    for (Eigen::Index c = 0; c < seen.cols(); ++c) {
      const FrameRate& frame_rate = carried[static_cast<std::size_t>(c % coordinates)];
      const Eigen::Vector3d arm = shape.ends[0].col(c / coordinates) - pose.position;
      seen.col(c).head<3>() =
          to_frame * (world.col(c).head<3>() - frame_rate.translation - frame_rate.rotation.cross(arm));
    }
    shape.rates.push_back(seen.cast<float>());
  }
  return shape;
}

}  // namespace cable_variation
