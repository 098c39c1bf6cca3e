// Neutral motions in words.
#include <cable_variation/equilibrium/discretisation/neutral_motions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cable_variation {
namespace {

std::string vectorText(const Eigen::Vector3d& v) {
  const auto shown = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };
  std::ostringstream text;
  text.precision(4);
  text << '(' << shown(v.x()) << ", " << shown(v.y()) << ", " << shown(v.z()) << ')';
  return text.str();
}

// The clips on the line through `point` along `direction`, at most one in each place; at most two.
std::vector<std::string> clipsOn(const RodSystem& system, const Configuration& configuration,
                                 const std::vector<bool>& moves, const Eigen::Vector3d& point,
                                 const Eigen::Vector3d& direction, double near) {
  std::vector<std::string> names;
  std::vector<Eigen::Vector3d> places;
  const Topology& topology = system.topology();
  for (std::size_t i = 0; i < topology.stations.size() && names.size() < 2; ++i) {
    const Station& station = topology.stations[i];
    if (!station.clip || !moves[station.cable]) continue;
    if (!system.harness().clips[*station.clip].constraint.holdsPosition()) continue;
    const Eigen::Vector3d& at = configuration.stations[i].pose.position;
    if ((at - point).cross(direction).norm() > near) continue;
    if (std::any_of(places.begin(), places.end(),
                    [&](const Eigen::Vector3d& other) { return (other - at).norm() < near; }))
      continue;
    places.push_back(at);
    names.push_back("'" + system.harness().clips[*station.clip].name + "'");
  }
  return names;
}

}  // namespace

std::string describe(const NeutralMotion& motion, const RodSystem& system,
                     const Configuration& configuration) {
  constexpr double kNear = 1e-6;  // of the largest turn, and of the longest cable
  const Topology& topology = system.topology();
  const double length = largestArcLength(configuration);
  double largest_turn = 0.0, largest_spin = 0.0, largest_shift = 0.0;
  const NeutralMotion::OfSpan* turning = nullptr;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < motion.spans.size(); ++i) {
    const NeutralMotion::OfSpan& of = motion.spans[i];
    largest_spin = std::max(largest_spin, std::abs(of.spin));
    largest_shift = std::max(largest_shift, of.translation.norm() / length);
    if (!(of.rotation.norm() > largest_turn)) continue;
    largest_turn = of.rotation.norm();
    turning = &of;
    origin = configuration.stations[topology.spans[i].left].pose.position;
  }
  const double largest = std::max({largest_turn, largest_spin, largest_shift});
  std::vector<bool> moves(system.harness().cables.size(), false);
  for (std::size_t i = 0; i < motion.spans.size(); ++i) {
    const NeutralMotion::OfSpan& of = motion.spans[i];
    if (std::max({of.rotation.norm(), std::abs(of.spin), of.translation.norm() / length}) > kNear * largest)
      moves[topology.spans[i].cable] = true;
  }
  std::string names;
  std::size_t moving = 0;
  for (std::size_t c = 0; c < moves.size(); ++c) {
    if (!moves[c]) continue;
    names += (moving++ == 0 ? "'" : ", '") + system.harness().cables[c].name + "'";
  }
  const std::string who = (moving == 1 ? "cable " : "cables ") + names + (moving == 1 ? " is" : " are");
  double largest_way = 0.0;
  for (const auto& nodes : fieldOf(motion, system, configuration).spans)
    largest_way = std::max(largest_way, nodes.topRows<3>().colwise().norm().maxCoeff());
  if (largest_way <= kNear * length * largest)
    return who + " free to turn about " + (moving == 1 ? "its own axis" : "their own axes");
  if (largest_turn <= kNear * largest) return who + " free to move without turning";
  const Eigen::Vector3d direction = turning->rotation / largest_turn;
  const double along = turning->translation.dot(direction);
  if (std::abs(along) > kNear * length * largest) return who + " free to move";
  const Eigen::Vector3d point = origin + direction.cross(turning->translation) / largest_turn;
  const std::vector<std::string> held =
      clipsOn(system, configuration, moves, point, direction, 10.0 * kNear * length);
  if (held.size() == 2) return who + " free to turn about the line through " + held[0] + " and " + held[1];
  Eigen::Vector3d shown = direction;
  Eigen::Index axis = 0;
  shown.cwiseAbs().maxCoeff(&axis);
  if (shown[axis] < 0.0) shown = -shown;
  const std::string where = held.empty() ? vectorText(point) + " m" : held[0];
  return who + " free to turn about the line through " + where + " along " + vectorText(shown);
}

}  // namespace cable_variation
