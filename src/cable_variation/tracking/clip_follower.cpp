#include <cable_variation/tracking/clip_follower.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <cable_variation/tracking/clip_way.h>
#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {
namespace {

// As ShapeFollower's, which follows deviations: shares of the motion and of the longest cable.
constexpr double kSmoothShare = 0.1, kStepOfLength = 0.002;
constexpr double kOddOfLength = 0.01;
constexpr double kLargestMotion = 0.05;
constexpr double kSmallestStep = 1.0 / 128.0;
constexpr int kMostSolves = 400;  // a jump takes some 20, a metre's leap of a cable as long some 60
constexpr int kPlaces = 24;       // along each cable, where shapes are compared

/// A shape on the way, seen at the same places of all cables.
struct Station {
  double share = 0.0;
  EquilibriumSolver solver;
  Equilibrium equilibrium;
  Eigen::Matrix3Xd places;     // [m]
  Eigen::Matrix3Xd responses;  // per unit of the share [m]
};

/// The response of a shape's material at an arc length, linear between its points.
Eigen::Vector3d responseAt(const CableShape& shape, const std::vector<ShapePointRate>& rates, double s) {
  const auto motion = [&](std::size_t i) -> Eigen::Vector3d {
    return rates[i].position - rates[i].arc_length * shape.points[i].tangent;
  };
  const auto after =
      std::upper_bound(shape.points.begin(), shape.points.end(), s,
                       [](double at, const ShapePoint& point) { return at < point.arc_length; });
  if (after == shape.points.begin()) return motion(0);
  if (after == shape.points.end()) return motion(shape.points.size() - 1);
  const auto right = static_cast<std::size_t>(after - shape.points.begin());
  const double left_at = shape.points[right - 1].arc_length;
  const double share = (s - left_at) / (after->arc_length - left_at);
  return (1.0 - share) * motion(right - 1) + share * motion(right);
}

class ClipFollower {
 public:
  ClipFollower(const Harness& from, const Harness& to) : way_(from, to), end_(to) {
    for (const Cable& cable : from.cables) {
      lengths_.push_back(cable.length);
      longest_ = std::max(longest_, cable.length);
    }
  }

  FollowedClips follow(EquilibriumSolver& solver, const Equilibrium& before) {
    Station here{0.0, solver, before, {}, {}};
    look(here);
    double step = 1.0;
    while (here.share < 1.0) {
      const double next = std::min(1.0, here.share + step);
      Station there = stationAt(next, here.solver);
      const bool smooth = there.equilibrium.converged() && isSmooth(here, there);
      const bool smallest = step <= kSmallestStep;
      if (!smooth && !smallest && followed_.solves < kMostSolves) {
        step *= 0.5;
        continue;
      }
      if (!there.equilibrium.converged()) {
        leap(here, solver);
        return std::move(followed_);
      }
      if (smooth) {
        step *= 2.0;
      } else if (smallest && odd(here, there).distance > kOddOfLength * longest_ && !goesBack(here, there)) {
        tellJump(here, there);
      }
      here = std::move(there);
    }
    followed_.equilibrium = std::move(here.equilibrium);
    solver = std::move(here.solver);
    return std::move(followed_);
  }

  bool empty() const { return way_.empty(); }

 private:
  Station stationAt(double share, const EquilibriumSolver& from) {
    Station station{share, from, {}, {}, {}};
    station.equilibrium = station.solver.update(share == 1.0 ? end_ : way_.at(share));
    ++followed_.solves;
    if (station.equilibrium.converged()) look(station);
    return station;
  }

  void look(Station& station) const {
    const EquilibriumRate rate = std::move(station.solver.differentiate({way_.rate()}).front());
    const std::vector<CableShape>& shapes = station.equilibrium.shapes;
    const auto count = static_cast<Eigen::Index>(shapes.size()) * kPlaces;
    station.places.resize(3, count);
    station.responses.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const CableShape& shape = shapes[cableAt(i)];
      station.places.col(i) = shape.position(arcLengthAt(i));
      station.responses.col(i) = responseAt(shape, rate.shapes[cableAt(i)], arcLengthAt(i));
    }
  }

  static std::size_t cableAt(Eigen::Index place) { return static_cast<std::size_t>(place / kPlaces); }
  double arcLengthAt(Eigen::Index place) const {
    return lengths_[cableAt(place)] * static_cast<double>(place % kPlaces) / (kPlaces - 1);
  }

  /// Of the step from what the responses at its ends explain.
  static LargestDistance odd(const Station& a, const Station& b) {
    return largestDistance(b.places - a.places, 0.5 * (b.share - a.share) * (a.responses + b.responses));
  }

  bool isSmooth(const Station& a, const Station& b) const {
    const double motion = largestDistance(a.places, b.places).distance;
    return motion <= kLargestMotion * longest_ &&
           odd(a, b).distance <= kSmoothShare * motion + kStepOfLength * longest_;
  }

  /// Whether the shape that was found ahead comes back to the one it was to come from: steep, but no jump.
  bool goesBack(const Station& here, const Station& there) {
    const Station back = stationAt(here.share, there.solver);
    return back.equilibrium.converged() &&
           largestDistance(back.places, here.places).distance < kStepOfLength * longest_;
  }

  void tellJump(const Station& here, const Station& there) {
    const LargestDistance far = odd(here, there);
    if (followed_.jump && followed_.jump->distance >= far.distance) return;
    followed_.jump = {here.share,
                      far.distance,
                      cableAt(far.column),
                      arcLengthAt(far.column),
                      here.equilibrium.energy.total(),
                      there.equilibrium.energy.total(),
                      here.equilibrium.smallest_eigenvalue};
  }

  /// The way on has no equilibrium; perhaps its end has one.
  void leap(const Station& here, EquilibriumSolver& solver) {
    const Station there = stationAt(1.0, here.solver);
    followed_.equilibrium = there.equilibrium;
    if (!there.equilibrium.converged()) return;
    tellJump(here, there);
    solver = there.solver;
  }

  ClipWay way_;
  Harness end_;
  std::vector<double> lengths_;
  double longest_ = 0.0;  // [m]
  FollowedClips followed_;
};

}  // namespace

FollowedClips followClips(EquilibriumSolver& solver, const Harness& from, const Equilibrium& before,
                          const Harness& to) {
  if (!to.contacts.empty()) {  // without derivatives there is no prediction that a jump would be told by
    FollowedClips followed;
    followed.equilibrium = solver.update(to);
    followed.solves = 1;
    return followed;
  }
  ClipFollower follower(from, to);
  if (!follower.empty()) return follower.follow(solver, before);
  FollowedClips followed;
  followed.equilibrium = before;
  return followed;
}

}  // namespace cable_variation
