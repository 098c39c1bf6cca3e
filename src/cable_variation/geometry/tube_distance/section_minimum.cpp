#include <cable_variation/geometry/tube_distance/section_minimum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cable_variation {
namespace {

constexpr double kTolerance = 1e-9;   // of a value [m]
constexpr double kNothing = 1e-15;    // likewise, lost in rounding
constexpr int kMostSteps = 80;        // bisection alone needs 52
constexpr double kNarrowest = 1e-12;  // a part of the section that is not divided further

struct Interval {
  double a, b;  // of u
  ControlPoints control;
};

// From below, of the distance to the triangle's plane all along the section.
double heightBound(const TubeSection& section, const SurfaceTriangle& triangle) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector3d& point : section.control) {
    const double height = triangle.normal.dot(point - triangle.corners[0]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return std::max(low, -high);
}

// From below, over the interval, of the value: by the plane of a nearest point there.
double planeBound(const Interval& interval, const TubeSection& section, const SectionMinimum& at) {
  std::array<double, 6> values;
  const double start = section.radius(interval.a), end = section.radius(interval.b);
  for (std::size_t i = 0; i < 6; ++i) {
    values[i] = at.nearest.direction.dot(interval.control[i] - at.nearest.point) - start -
                0.2 * static_cast<double>(i) * (end - start);
  }
  double bound = *std::min_element(values.begin(), values.end());
  // A convex polynomial lies above its tangent at u.
  bool convex = true;
  for (std::size_t i = 0; i + 2 < 6; ++i) {
    convex = convex && values[i] - 2.0 * values[i + 1] + values[i + 2] >= 0.0;
  }
  if (convex) {
    const double slope = at.nearest.direction.dot(section.derivatives(at.u).first) -
                         (section.end_radius - section.start_radius);
    bound = std::max(bound, at.value + std::min(slope * (interval.a - at.u), slope * (interval.b - at.u)));
  }
  return std::max(bound, -std::max(start, end));
}

// A local minimum within the interval, by Newton's method on the slope within a bracket.
SectionMinimum localMinimum(const TubeSection& section, const SurfaceTriangle& triangle, double a, double b,
                            const SectionMinimum& from) {
  const double taper = section.end_radius - section.start_radius;
  SectionMinimum best = from;
  double u = from.u, low = a, high = b;
  bool low_tried = false, high_tried = false;
  double width = 2.0 * (b - a);
  for (int step = 0; step < kMostSteps; ++step) {
    const TubeSection::Derivatives curve = section.derivatives(u);
    SectionMinimum here{0.0, u, nearestPoint(triangle, curve.position)};
    here.value = here.nearest.distance - section.radius(u);
    if (here.value < best.value) best = here;

    const Eigen::Vector3d& n = here.nearest.direction;
    const double approach = n.dot(curve.first);
    const double slope = approach - taper;
    if (slope == 0.0) break;
    (slope > 0.0 ? high : low) = u;
    (slope > 0.0 ? high_tried : low_tried) = true;
    if (high - low <= 1e-15 || (u == a && slope > 0.0) || (u == b && slope < 0.0)) break;

    double bend = n.dot(curve.second);
    if (here.nearest.on != NearestPoint::On::face && here.nearest.distance > 0.0) {
      double sideways = curve.first.squaredNorm() - approach * approach;
      if (here.nearest.on == NearestPoint::On::edge) {
        const double along = here.nearest.edge.dot(curve.first);
        sideways -= along * along / here.nearest.edge.squaredNorm();
      }
      bend += std::max(sideways, 0.0) / here.nearest.distance;
    }
    double length = bend > 0.0 ? std::abs(slope) / bend : std::numeric_limits<double>::infinity();
    // no further than to the surface, which a curve that pierces it crosses there
    if (slope * approach > 0.0) length = std::min(length, here.nearest.distance / std::abs(approach));
    double next = slope > 0.0 ? u - length : u + length;
    // what is left to gain
    if (std::abs(slope * (next - u)) <= kNothing) break;
    const bool slow = high - low > 0.5 * width;
    width = high - low;
    if (next <= low) {
      next = low_tried ? 0.5 * (low + high) : low;
    } else if (next >= high) {
      next = high_tried ? 0.5 * (low + high) : high;
    } else if (slow && step > 4 && step % 2 == 1) {
      next = 0.5 * (low + high);
    }
    u = next;
  }
  return best;
}

}  // namespace

SectionMinimum valueAt(const TubeSection& section, const SurfaceTriangle& triangle, double u) {
  SectionMinimum at{0.0, u, nearestPoint(triangle, section.position(u))};
  at.value = at.nearest.distance - section.radius(u);
  return at;
}

std::optional<SectionMinimum> smallest(const TubeSection& section, const SurfaceTriangle& triangle,
                                       double cutoff) {
  // a first sieve: the distance to the triangle's plane, of the middle, then of the whole curve
  const double within = cutoff + section.reach + section.largestRadius();
  if (std::abs(triangle.normal.dot(section.middle - triangle.corners[0])) >= within) return std::nullopt;
  if (heightBound(section, triangle) >= cutoff + section.largestRadius()) return std::nullopt;
  SectionMinimum best{0.0, 0.5, nearestPoint(triangle, section.middle)};
  if (best.nearest.distance >= within) return std::nullopt;
  best.value = best.nearest.distance - section.radius(0.5);
  const Interval whole{0.0, 1.0, section.control};
  if (planeBound(whole, section, best) >= cutoff) return std::nullopt;

  if (best.value >= cutoff) {
    // the halves' bounds are four times as sharp, and cost less than the minimum
    const auto [left, right] = halves(section.control);
    const auto isBeyond = [&](const Interval& half) {
      return planeBound(half, section, valueAt(section, triangle, 0.5 * (half.a + half.b))) >= cutoff;
    };
    if (isBeyond({0.0, 0.5, left}) && isBeyond({0.5, 1.0, right})) return std::nullopt;
  }
  best = localMinimum(section, triangle, 0.0, 1.0, best);
  const auto done = [&](double bound) { return bound >= std::min(cutoff, best.value - kTolerance); };
  if (!done(planeBound(whole, section, best))) {
    std::vector<Interval> open = {whole};
    while (!open.empty()) {
      const Interval interval = open.back();
      open.pop_back();
      const double middle = 0.5 * (interval.a + interval.b);
      const auto [left, right] = halves(interval.control);
      for (const Interval& half : {Interval{interval.a, middle, left}, Interval{middle, interval.b, right}}) {
        SectionMinimum at = valueAt(section, triangle, 0.5 * (half.a + half.b));
        if (done(planeBound(half, section, at))) continue;
        at = localMinimum(section, triangle, half.a, half.b, at);
        if (at.value < best.value) best = at;
        if (done(planeBound(half, section, at)) || half.b - half.a < kNarrowest) continue;
        open.push_back(half);
      }
    }
  }
  if (best.value < cutoff) return best;
  return std::nullopt;
}

}  // namespace cable_variation
