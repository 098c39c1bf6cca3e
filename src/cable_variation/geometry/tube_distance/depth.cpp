#include <cable_variation/geometry/tube_distance/depth.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace cable_variation {
namespace {

constexpr double kTolerance = 1e-9;  // of a depth [m]
// A depth that does not matter, half of what distances are promised to: a centreline that runs along a
// surface closer than that is not searched all along for places inside [m]. So is one a little further off,
// by so many intervals: what they could hide is less deep than twice their length.
constexpr double kNoDepth = 5e-8;
constexpr std::size_t kMostIntervals = 300000;
constexpr double kNarrowest = 1e-13;      // part of a section
constexpr double kOnSurface = 1e-10;      // below which it does not matter which side a place is on [m]
constexpr double kOtherDirection = 0.01;  // between directions that count as two [rad]
constexpr double kFinestMargin = 1e-8;    // a flat maximum is not looked at more closely [m]
constexpr int kMostSteps = 20;            // of Newton's method

using Nearest = DistancePart::Impl::Nearest;

// A place and how deep it lies; negative: outside.
struct Sample {
  double u = 0.0;
  double depth = 0.0;
  Eigen::Vector3d position;
  Nearest nearest;
};

struct Interval {
  std::size_t section = 0;
  Sample a, b;
  ControlPoints control;
  double deepest = 0.0;  // no place is deeper [m]
  double bound = 0.0;    // nor is with its radius included [m]

  bool operator<(const Interval& other) const { return bound < other.bound; }
};

class Search {
 public:
  Search(const DistancePart::Impl& part, std::uint32_t solid, const std::vector<TubeSection>& sections)
      : part_(part), solid_(solid), sections_(sections) {}

  // near: a place whose depth is known; depths differ by no more than the places.
  Sample sample(std::size_t section, double u, const Sample* near = nullptr) const {
    const Eigen::Vector3d x = sections_[section].position(u);
    const double apart = near ? (x - near->position).norm() : std::numeric_limits<double>::infinity();
    const double reach = near ? std::abs(near->depth) + apart + kTolerance : apart;
    Sample here{u, 0.0, x, *part_.nearestOn(solid_, x, reach)};
    here.depth = here.nearest.at.distance;
    if (here.depth < kOnSurface) {
      here.depth = 0.0;
    } else if (near && std::abs(near->depth) > apart) {
      here.depth = std::copysign(here.depth, near->depth);
    } else {
      const std::vector<std::uint32_t> around = part_.solidsAround(x);
      if (std::find(around.begin(), around.end(), solid_) == around.end()) here.depth = -here.depth;
    }
    return here;
  }

  Interval interval(std::size_t number, const Sample& a, const Sample& b,
                    const ControlPoints& control) const {
    const TubeSection& section = sections_[number];
    Interval made{number, a, b, control, 0.0, 0.0};
    double way = 0.0;
    for (std::size_t i = 0; i + 1 < 6; ++i) way += (control[i + 1] - control[i]).norm();
    // depth changes no faster than along the way
    made.deepest = 0.5 * (a.depth + b.depth + way);
    // and is no more than the distance to one triangle, which along a chord is largest at an end
    const double sagitta = sagittaBound(control);
    for (const Sample* end : {&a, &b}) {
      const Sample& other = end == &a ? b : a;
      const SurfaceTriangle& triangle = part_.boundary().triangles[end->nearest.triangle];
      const double there = nearestPoint(triangle, other.position).distance;
      made.deepest = std::min(made.deepest, std::max(std::abs(end->depth), there) + sagitta);
    }
    made.bound = made.deepest + std::max(section.radius(a.u), section.radius(b.u));
    return made;
  }

  // Where the distance to one triangle, radius included, is stationary: the deepest place, if smooth there.
  Sample polished(std::size_t number, const Sample& from) const {
    const TubeSection& section = sections_[number];
    const SurfaceTriangle& triangle = part_.boundary().triangles[from.nearest.triangle];
    double u = from.u;
    for (int step = 0; step < kMostSteps; ++step) {
      const TubeSection::Derivatives curve = section.derivatives(u);
      const NearestPoint at = nearestPoint(triangle, curve.position);
      const double approach = at.direction.dot(curve.first);
      const double slope = approach + section.end_radius - section.start_radius;
      double bend = at.direction.dot(curve.second);
      if (at.on != NearestPoint::On::face && at.distance > 0.0) {
        double sideways = curve.first.squaredNorm() - approach * approach;
        if (at.on == NearestPoint::On::edge) {
          const double along = at.edge.dot(curve.first);
          sideways -= along * along / at.edge.squaredNorm();
        }
        bend += sideways / at.distance;
      }
      if (bend >= 0.0) return from;  // no smooth maximum
      const double next = std::clamp(u - slope / bend, 0.0, 1.0);
      if (std::abs(next - u) <= 1e-16) break;
      u = next;
    }
    const Sample there = sample(number, u, &from);
    return value(number, there) > value(number, from) ? there : from;
  }

  double value(std::size_t section, const Sample& sample) const {
    return sample.depth + sections_[section].radius(sample.u);
  }

 private:
  const DistancePart::Impl& part_;
  std::uint32_t solid_;
  const std::vector<TubeSection>& sections_;
};

}  // namespace

std::optional<Deepest> deepest(const DistancePart::Impl& part, std::uint32_t solid,
                               const std::vector<TubeSection>& sections, double margin) {
  margin = std::max(margin, kFinestMargin);
  const Search search(part, solid, sections);
  struct Found {
    std::size_t section;
    Sample sample;
    double value;
  };
  std::vector<Found> found;
  Found best{0, {}, -std::numeric_limits<double>::infinity()};
  const auto take = [&](std::size_t section, const Sample& sample) {
    if (sample.depth <= 0.0) return;
    found.push_back({section, sample, search.value(section, sample)});
    if (found.back().value > best.value) best = found.back();
  };

  std::priority_queue<Interval> open;
  const auto boxes = [&](const TubeSection& section) {
    return std::any_of(part.solids.shells.begin(), part.solids.shells.end(), [&](const Solids::Shell& shell) {
      return shell.solid == solid && squaredGap(shell.box, section.box) == 0.0;
    });
  };
  std::optional<Sample> last;
  std::size_t last_section = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!boxes(sections[i])) continue;
    const bool goes_on = last && last_section + 1 == i && sections[i - 1].continued;
    const Sample a = goes_on ? Sample{0.0, last->depth, last->position, last->nearest}
                             : search.sample(i, 0.0, last ? &*last : nullptr);
    const Sample b = search.sample(i, 1.0, &a);
    last = b;
    last_section = i;
    take(i, a);
    take(i, b);
    open.push(search.interval(i, a, b, sections[i].control));
  }
  for (std::size_t seen = 0; !open.empty() && seen < kMostIntervals; ++seen) {
    const Interval interval = open.top();
    open.pop();
    const double ends =
        std::max(search.value(interval.section, interval.a), search.value(interval.section, interval.b));
    const bool deeper = interval.bound > std::max(best.value, 0.0) + kTolerance;
    const bool as_deep = interval.bound > best.value - margin && interval.bound - ends > 0.1 * margin;
    if (!deeper && !as_deep) {
      if (interval.bound <= best.value - margin) break;
      continue;
    }
    // what lies in the surface or outside is not inside
    if (interval.deepest <= kNoDepth || interval.b.u - interval.a.u < kNarrowest) continue;
    const Sample middle = search.sample(interval.section, 0.5 * (interval.a.u + interval.b.u), &interval.a);
    take(interval.section, middle);
    const auto [left, right] = halves(interval.control);
    open.push(search.interval(interval.section, interval.a, middle, left));
    open.push(search.interval(interval.section, middle, interval.b, right));
  }
  if (found.empty()) return std::nullopt;
  best.sample = search.polished(best.section, best.sample);
  best.value = search.value(best.section, best.sample);

  Deepest result{-best.value,
                 best.section,
                 best.sample.u,
                 best.sample.nearest,
                 part.winding(best.sample.position),
                 std::numeric_limits<double>::infinity()};
  constexpr std::size_t kPlacesAsked = 32;
  const std::size_t step = 1 + found.size() / kPlacesAsked;
  for (std::size_t i = 0; i < found.size() && !result.winding.clear; i += step) {
    const DistancePart::Impl::Winding there = part.winding(found[i].sample.position);
    if (there.clear) result.winding = there;
  }
  const TubeSection& section = sections[best.section];
  const Eigen::Vector3d& x = best.sample.position;
  const double radius = section.radius(best.sample.u);
  forEachNear(part.boundary(), x, best.sample.depth + margin, [&](std::uint32_t triangle) {
    if (part.solidOf(triangle) != solid) return;
    const NearestPoint at = nearestPoint(part.boundary().triangles[triangle], x);
    const double value = -at.distance - radius;
    if (at.distance <= best.sample.depth + margin &&
        (at.direction - best.sample.nearest.at.direction).norm() > kOtherDirection &&
        isLocallyNearest(part.boundary(), x, at)) {
      result.runner_up = std::min(result.runner_up, std::max(value, result.value));
    }
  });
  for (const Found& other : found) {
    const double apart = (other.sample.position - x).norm();
    if (other.value >= best.value - margin && apart > 2.0 * radius) {
      result.runner_up = std::min(result.runner_up, -other.value);
    }
  }
  return result;
}

}  // namespace cable_variation
