#include <cable_variation/equilibrium/search/shape_from.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/equilibrium/discretisation/contact_result.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/start_search.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

void requireShapesOf(const Harness& harness, const std::vector<CableShape>& shapes) {
  std::ostringstream text;
  if (shapes.size() != harness.cables.size()) {
    text << shapes.size() << " shapes to start from; expected one for each of the " << harness.cables.size()
         << " cables";
    throw std::invalid_argument(text.str());
  }
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    if (shapes[c].cable == harness.cables[c].name && shapes[c].points.size() >= 2) continue;
    text << "shape " << c << " to start from is of cable '" << shapes[c].cable << "' with "
         << shapes[c].points.size() << " points; expected one of cable '" << harness.cables[c].name << "'";
    throw std::invalid_argument(text.str());
  }
}

bool isLocked(const ClipFreedom& freedom) { return freedom.kind == ClipFreedom::Kind::locked; }

double angleAbout(const Eigen::Vector3d& axis, const Eigen::Quaterniond& turn) {
  return std::remainder(2.0 * std::atan2(turn.vec().dot(axis), turn.w()), 2.0 * M_PI);
}

// The coordinates in a clip of a section at `pose`, as far as the clip lets it be there.
void setCoordinates(const Clip& clip, const Pose& pose, StationConfiguration& at) {
  const Pose in_clip = clip.pose.inverse() * pose;
  at.offset = in_clip.position;
  at.rotation = so3::log(in_clip.orientation);
  int free_turns = 0;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    if (isLocked(clip.constraint.translation[axis])) at.offset[k] = 0.0;
    if (!isLocked(clip.constraint.rotation[axis])) ++free_turns;
  }
  for (int k = 0; k < 3; ++k) {
    if (isLocked(clip.constraint.rotation[static_cast<std::size_t>(k)])) {
      at.rotation[k] = 0.0;
    } else if (free_turns == 1) {
      at.rotation[k] = angleAbout(Eigen::Vector3d::Unit(k), in_clip.orientation);
    }
  }
}

// All stations at their sections of the shapes, and where clips and joints have them.
Configuration stationsOn(const std::vector<CableShape>& shapes, const Problem& problem) {
  const Harness& harness = problem.harness;
  const Topology& topology = problem.topology;
  Configuration configuration;
  configuration.spans.resize(topology.spans.size());
  for (const Station& station : topology.stations) {
    StationConfiguration at;
    at.arc_length = station.arc_length;
    at.pose = shapes[station.cable].pose(station.arc_length);
    if (station.clip) setCoordinates(harness.clips[*station.clip], at.pose, at);
    configuration.stations.push_back(at);
  }
  for (std::size_t index : topology.order) {
    const Station& station = topology.stations[index];
    if (!station.joint || harness.joints[*station.joint].type != Joint::Type::hinge) continue;
    const Joint& joint = harness.joints[*station.joint];
    StationConfiguration& at = configuration.stations[index];
    const Eigen::Quaterniond unturned =
        configuration.stations[*station.parent].pose.orientation * joint.rotation;
    at.hinge_angle = angleAbout(joint.axis, unturned.conjugate() * at.pose.orientation);
  }
  placeStations(harness, topology, configuration);
  return configuration;
}

// Whether the branch comes to rest, is refined and has all loads; else the result says what is wrong.
bool comesToRest(Branch& branch, const Harness& harness, bool conservative, Equilibrium& result) {
  const Problem& problem = branch.problem();
  if (branch.letGo(result) && branch.tighten(result) &&
      (conservative || branch.growMoments(harness, result))) {
    problem.system->evaluate(problem.configuration, RodSystem::Hessian::none);
    if (branch.adaptGrid(result)) return true;
  }
  if (!result.message.empty()) return false;
  result.status = EquilibriumStatus::not_converged;
  result.message = "the shape did not come to rest from where it was let go: " +
                   whereItFailed(problem.harness, problem.topology, *problem.system, problem.configuration);
  return false;
}

}  // namespace

std::unique_ptr<Branch> shapeFrom(const Harness& harness, const std::vector<CableShape>& shapes,
                                  const EquilibriumOptions& options, Equilibrium& result) {
  requireShapesOf(harness, shapes);
  auto branch = std::make_unique<Branch>(harness, options);
  Problem& problem = branch->problem();
  const bool conservative = problem.system->conservative();
  if (!conservative) branch->dropMoments();
  const Configuration stations = stationsOn(shapes, problem);
  result.message = unreachable(problem.harness, problem.topology, stations, kLargestStretch);
  if (!result.message.empty()) {
    result.status = EquilibriumStatus::impossible;
    return nullptr;
  }
  problem.configuration = onGrid(problem.topology, stations, shapes, problem.system->grid());
  if (problem.system->contact()) {
    if (const auto crossed = problem.system->contact()->crossed(problem.configuration)) {
      result.status = EquilibriumStatus::not_converged;
      result.message = "the shape to start from: " + passesThrough(problem.harness, *crossed);
      return nullptr;
    }
  }
  if (!comesToRest(*branch, harness, conservative, result)) return nullptr;
  return branch;
}

}  // namespace cable_variation
