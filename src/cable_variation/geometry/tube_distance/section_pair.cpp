#include <cable_variation/geometry/tube_distance/section_pair.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <cable_variation/geometry/tube_distance/parallel_bound.h>

namespace cable_variation {
namespace {

constexpr double kTolerance = 1e-8;     // of a value [m]
constexpr double kNarrowest = 1e-12;    // part of a section
constexpr double kNoDirection = 1e-13;  // centrelines that cross [m]
constexpr int kMostSteps = 40;          // of Newton's method
constexpr int kGoldenSteps = 80;        // 0.618^80 = 2e-17
constexpr double kActive = 1e-12;       // a condition met this closely holds the pair [m]

struct Interval {
  double a = 0.0, b = 1.0;
  ControlPoints control;
};

struct Rectangle {
  Interval first, second;
};

double taper(const TubeSection& section) { return section.end_radius - section.start_radius; }

struct Slopes {
  double first, second;  // of the value, over u and v
};

Slopes slopesAt(const TubeSection& first, const TubeSection& second, const PairMinimum& at) {
  return {at.direction.dot(first.derivatives(at.u).first) - taper(first),
          -at.direction.dot(second.derivatives(at.v).first) - taper(second)};
}

// From below, over the interval, of n·(c - c(u)) - (r - r(u)) - weight * (parameter - u); slope: its own at
// u, with a weight of 0.
double sideBound(const Interval& interval, const TubeSection& section, double u, const Eigen::Vector3d& n,
                 double slope, double weight) {
  const Eigen::Vector3d origin = section.position(u);
  std::array<double, 6> values;
  for (std::size_t i = 0; i < 6; ++i) {
    const double parameter = interval.a + 0.2 * static_cast<double>(i) * (interval.b - interval.a);
    values[i] = n.dot(interval.control[i] - origin) - (taper(section) + weight) * (parameter - u);
  }
  double bound = *std::min_element(values.begin(), values.end());
  bool convex = true;
  for (std::size_t i = 0; i + 2 < 6; ++i) {
    convex = convex && values[i] - 2.0 * values[i + 1] + values[i + 2] >= 0.0;
  }
  if (convex) {
    const double rest = slope - weight;
    bound = std::max(bound, std::min(rest * (interval.a - u), rest * (interval.b - u)));
  }
  return bound;
}

class Search {
 public:
  Search(const TubeSection& first, const TubeSection& second, const WayCondition& condition)
      : first_(first), second_(second), condition_(condition) {}

  bool counts(double u, double v) const { return condition_.excess(u, v) >= -kActive; }

  /// Whether any pair of the rectangle can count.
  bool mayCount(const Rectangle& rectangle) const {
    const auto furthest = [](const Interval& interval, double slope) {
      return slope > 0.0 ? interval.b : interval.a;
    };
    return counts(furthest(rectangle.first, condition_.first_slope),
                  furthest(rectangle.second, condition_.second_slope));
  }

  /// From below, over the pairs of the rectangle that count; at: any pair.
  double bound(const Rectangle& rectangle, const PairMinimum& at) const {
    const Slopes slopes = slopesAt(first_, second_, at);
    // On pairs that count, a multiple of the excess can be taken off: Lagrange's, where the condition holds.
    double weight = 0.0, taken = 0.0;
    const double excess = condition_.excess(at.u, at.v);
    if (std::abs(excess) <= kActive) {
      const double squared =
          condition_.first_slope * condition_.first_slope + condition_.second_slope * condition_.second_slope;
      weight = std::max(
          0.0, (slopes.first * condition_.first_slope + slopes.second * condition_.second_slope) / squared);
      taken = weight * excess;
    }
    const double sum = at.value - taken +
                       sideBound(rectangle.first, first_, at.u, at.direction, slopes.first,
                                 weight * condition_.first_slope) +
                       sideBound(rectangle.second, second_, at.v, -at.direction, slopes.second,
                                 weight * condition_.second_slope);
    return std::max(sum,
                    -std::max(first_.radius(rectangle.first.a), first_.radius(rectangle.first.b)) -
                        std::max(second_.radius(rectangle.second.a), second_.radius(rectangle.second.b)));
  }

  /// The same for cylinders that run beside each other.
  double boundBeside(const Rectangle& rectangle) const {
    if (taper(first_) != 0.0 || taper(second_) != 0.0) return -std::numeric_limits<double>::infinity();
    const double first = parallelBound(first_, rectangle.first.control, second_).value_or(0.0);
    const double second = parallelBound(second_, rectangle.second.control, first_).value_or(0.0);
    return std::max(first, second) - first_.start_radius - second_.start_radius;
  }

  /// A local minimum within the rectangle, by Newton's method on half the squared distance; where that does
  /// not count, one along the line of the pairs that just do. None if no pair was found that counts.
  std::optional<PairMinimum> localMinimum(const Rectangle& rectangle) const {
    const Interval &p = rectangle.first, &q = rectangle.second;
    PairMinimum best = valueAt(first_, second_, 0.5 * (p.a + p.b), 0.5 * (q.a + q.b));
    for (int step = 0; step < kMostSteps && best.distance > kNoDirection; ++step) {
      const PairMinimum next = improved(rectangle, best);
      if (!(next.value < best.value)) break;
      best = next;
    }
    if (counts(best.u, best.v)) return best;
    return alongLine(rectangle);
  }

 private:
  PairMinimum improved(const Rectangle& rectangle, const PairMinimum& at) const {
    const Interval &p = rectangle.first, &q = rectangle.second;
    const TubeSection::Derivatives a = first_.derivatives(at.u), b = second_.derivatives(at.v);
    const Eigen::Vector3d apart = a.position - b.position;
    const double gu = apart.dot(a.first) - at.distance * taper(first_);
    const double gv = -apart.dot(b.first) - at.distance * taper(second_);
    const bool free_u = !((at.u <= p.a && gu >= 0.0) || (at.u >= p.b && gu <= 0.0));
    const bool free_v = !((at.v <= q.a && gv >= 0.0) || (at.v >= q.b && gv <= 0.0));
    if (!free_u && !free_v) return at;
    double uu = a.first.squaredNorm() + apart.dot(a.second), uv = -a.first.dot(b.first);
    double vv = b.first.squaredNorm() - apart.dot(b.second);
    const double floor_u = 1e-6 * a.first.squaredNorm(), floor_v = 1e-6 * b.first.squaredNorm();
    double du = 0.0, dv = 0.0;
    if (free_u && free_v) {
      if (uu < floor_u || vv < floor_v || uu * vv - uv * uv < 1e-12 * uu * vv) {
        // without the curvature the matrix is at least semidefinite
        uu = (1.0 + 1e-9) * a.first.squaredNorm();
        vv = (1.0 + 1e-9) * b.first.squaredNorm();
      }
      const double determinant = uu * vv - uv * uv;
      du = -(vv * gu - uv * gv) / determinant;
      dv = -(uu * gv - uv * gu) / determinant;
    } else if (free_u) {
      du = -gu / std::max(uu, floor_u);
    } else {
      dv = -gv / std::max(vv, floor_v);
    }
    for (double part = 1.0; part > 1e-4; part *= 0.25) {
      const PairMinimum next = valueAt(first_, second_, std::clamp(at.u + part * du, p.a, p.b),
                                       std::clamp(at.v + part * dv, q.a, q.b));
      if (next.value < at.value) return next;
    }
    return at;
  }

  // On the line excess = 0 within the rectangle, by golden section.
  std::optional<PairMinimum> alongLine(const Rectangle& rectangle) const {
    const Interval &p = rectangle.first, &q = rectangle.second;
    const auto v_at = [&](double u) { return -condition_.excess(u, 0.0) / condition_.second_slope; };
    const auto u_at = [&](double v) { return -condition_.excess(0.0, v) / condition_.first_slope; };
    const double u_a = u_at(q.a), u_b = u_at(q.b);
    double low = std::max(p.a, std::min(u_a, u_b)), high = std::min(p.b, std::max(u_a, u_b));
    if (!(low <= high)) return std::nullopt;
    const auto at = [&](double u) { return valueAt(first_, second_, u, std::clamp(v_at(u), q.a, q.b)); };
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    PairMinimum left = at(high - golden * (high - low)), right = at(low + golden * (high - low));
    const PairMinimum start = at(low), end = at(high);
    for (int step = 0; step < kGoldenSteps; ++step) {
      if (left.value < right.value) {
        high = right.u;
        right = left;
        left = at(high - golden * (high - low));
      } else {
        low = left.u;
        left = right;
        right = at(low + golden * (high - low));
      }
    }
    return std::min({left, right, start, end},
                    [](const PairMinimum& a, const PairMinimum& b) { return a.value < b.value; });
  }

  const TubeSection& first_;
  const TubeSection& second_;
  const WayCondition& condition_;
};

}  // namespace

PairMinimum valueAt(const TubeSection& first, const TubeSection& second, double u, double v) {
  const Eigen::Vector3d apart = first.position(u) - second.position(v);
  PairMinimum at;
  at.u = u;
  at.v = v;
  at.distance = apart.norm();
  at.value = at.distance - first.radius(u) - second.radius(v);
  if (at.distance > kNoDirection) {
    at.direction = apart / at.distance;
  } else {
    const Eigen::Vector3d tangent = first.derivatives(u).first;
    const Eigen::Vector3d across = tangent.cross(second.derivatives(v).first);
    at.direction = across.squaredNorm() > 0.0 ? Eigen::Vector3d(across.normalized()) : someNormal(tangent);
  }
  return at;
}

std::optional<PairMinimum> smallest(const TubeSection& first, const TubeSection& second,
                                    const WayCondition& condition, double cutoff) {
  const double clear = (first.middle - second.middle).norm() - first.reach - second.reach -
                       first.largestRadius() - second.largestRadius();
  if (clear >= cutoff) return std::nullopt;
  const Search search(first, second, condition);
  std::optional<PairMinimum> best;
  const auto done = [&](double bound) {
    return bound >= (best ? std::min(cutoff, best->value - kTolerance) : cutoff);
  };
  std::vector<Rectangle> open = {{{0.0, 1.0, first.control}, {0.0, 1.0, second.control}}};
  while (!open.empty()) {
    const Rectangle rectangle = open.back();
    open.pop_back();
    if (!search.mayCount(rectangle)) continue;
    const Interval &p = rectangle.first, &q = rectangle.second;
    if (done(search.bound(rectangle, valueAt(first, second, 0.5 * (p.a + p.b), 0.5 * (q.a + q.b))))) continue;
    if (const auto local = search.localMinimum(rectangle)) {
      if (!best || local->value < best->value) best = local;
      if (done(search.bound(rectangle, *local)) || done(search.boundBeside(rectangle))) continue;
    }
    if (p.b - p.a < kNarrowest && q.b - q.a < kNarrowest) continue;
    const double way_p = (p.control[5] - p.control[0]).norm(), way_q = (q.control[5] - q.control[0]).norm();
    const bool split_first = way_p >= way_q;
    const Interval& split = split_first ? p : q;
    const double middle = 0.5 * (split.a + split.b);
    const auto [left, right] = halves(split.control);
    for (const Interval& half : {Interval{split.a, middle, left}, Interval{middle, split.b, right}}) {
      open.push_back(split_first ? Rectangle{half, q} : Rectangle{p, half});
    }
  }
  if (best && best->value < cutoff) return best;
  return std::nullopt;
}

}  // namespace cable_variation
