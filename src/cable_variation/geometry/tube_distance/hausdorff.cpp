#include <cable_variation/geometry/tube_distance/hausdorff.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <cable_variation/geometry/tube_distance/nearest_place.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Place = Centreline::Place;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kExact = 1e-12;                // [m] tolerance of the distances reported
constexpr std::size_t kMostIntervals = 200000;  // far beyond what the accuracy of any cable takes

// A place of the curve that is measured, with the nearest one on the other.
struct Node {
  std::size_t piece;
  double t;
  PieceEnd at;
  double radius;
  double value;  ///< distance to the other curve, plus the radius here, minus the radius there
  Place foot;
};

// While the place goes linearly from one node to another, its distance is at most a linear function plus
// this.
struct Ceiling {
  double start, end, excess;
  double largest() const { return std::max(start, end) + excess; }
};

// The largest over the interval of the smaller of two ceilings.
double largest(const Ceiling& a, const Ceiling& b) {
  const double a0 = a.start + a.excess, a1 = a.end + a.excess;
  const double b0 = b.start + b.excess, b1 = b.end + b.excess;
  double top = std::max(std::min(a0, b0), std::min(a1, b1));
  const double gap0 = a0 - b0, gap1 = a1 - b1;
  if (gap0 * gap1 < 0.0) top = std::max(top, a0 + gap0 / (gap0 - gap1) * (a1 - a0));
  return top;
}

// The largest distance from a place of one curve to another curve.
//
// Branch and bound. On an interval whose ends have feet on the other curve, let the foot move linearly too:
// the difference vector is then a quintic, and at most the linear interpolation of its length at the ends
// plus an eighth of its second derivative. The excess shrinks with the square of the interval.
class DirectedSearch {
 public:
  DirectedSearch(const NearestPlace& from, const NearestPlace& to, double accuracy)
      : from_(from), to_(to), accuracy_(accuracy) {}

  struct Result {
    double value = -kInfinity;        ///< at `place`, a lower bound of the largest
    double upper_bound = -kInfinity;  ///< of the largest, or below the value to beat
    Place place, foot;
    bool unique = true;
  };

  /// @param to_beat nothing smaller is looked for
  Result run(double to_beat) {
    beat_ = to_beat;
    start();
    double remaining = -kInfinity;
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const Interval top = heap_.back();
      heap_.pop_back();
      if (top.bound <= std::max(beat_, best_.value) + accuracy_ || nodes_.size() > kMostIntervals) {
        remaining = top.bound;
        break;
      }
      const std::size_t middle = addNode(nodes_[top.a].piece, 0.5 * (nodes_[top.a].t + nodes_[top.b].t),
                                         nodes_[top.a].foot, nodes_[top.b].t - nodes_[top.a].t);
      addInterval(top.a, middle);
      addInterval(middle, top.b);
    }
    best_.upper_bound = std::max({remaining, discarded_, best_.value});
    if (best_.value > beat_) polish();
    best_.upper_bound = std::max(best_.upper_bound, best_.value);
    return best_;
  }

 private:
  struct Interval {
    double bound;
    std::size_t a, b;  ///< nodes
    bool operator<(const Interval& other) const { return bound < other.bound; }
  };

  void start() {
    const std::size_t pieces = from_.curve().pieces.size();
    nodes_.reserve(8 * pieces);
    heap_.reserve(2 * pieces);
    addNode(0, 0.0, {}, 1.0);
    for (std::size_t i = 0; i < pieces; ++i) {
      addNode(i, 1.0, nodes_.back().foot, 1.0);
      if (i + 1 == pieces) break;
      // the next piece starts where this one ends, with derivatives of its own
      Node start = nodes_.back();
      start.piece = i + 1;
      start.t = 0.0;
      start.at = PieceEnd(from_.curve().pieces[i + 1].curve, 0.0);
      start.value += from_.radius({i + 1, 0.0}) - start.radius;
      start.radius = from_.radius({i + 1, 0.0});
      nodes_.push_back(start);
    }
    for (std::size_t i = 0; i < pieces; ++i) addInterval(2 * i, 2 * i + 1);
  }

  // `width`: of t, in which the largest value is around, should this be it
  std::size_t addNode(std::size_t piece, double t, const Place& guess, double width) {
    const PieceEnd at(from_.curve().pieces[piece].curve, t);
    const NearestPlace::Found found = to_.find(at.position, guess, 1e-2 * accuracy_);
    const double radius = from_.radius({piece, t});
    nodes_.push_back({piece, t, at, radius, found.distance + radius, found.place});
    if (found.lower_bound + radius > best_.value) {
      best_.value = found.lower_bound + radius;
      best_.place = {piece, t};
      best_.foot = found.place;
      around_ = width;
    }
    return nodes_.size() - 1;
  }

  void addInterval(std::size_t a, std::size_t b) {
    const double enough = std::max(beat_, best_.value) + accuracy_;
    const Node& start = nodes_[a];
    const Node& end = nodes_[b];
    double bound = ceiling(start, end, start.foot, end.foot).largest();
    if (bound > enough) {
      // the feet may be on different branches: each followed on its own
      const Ceiling left = ceiling(start, end, start.foot, to_.slide(end.at.position, start.foot));
      const Ceiling right = ceiling(start, end, to_.slide(start.at.position, end.foot), end.foot);
      bound = std::min({bound, largest(left, right)});
    }
    if (bound > enough) {
      heap_.push_back({bound, a, b});
      std::push_heap(heap_.begin(), heap_.end());
    } else {
      discarded_ = std::max(discarded_, bound);
    }
  }

  // The foot moving from p to q linearly in arc length; infinite when that is far.
  Ceiling ceiling(const Node& a, const Node& b, const Place& p, const Place& q) const {
    constexpr std::size_t kFar = 4;
    if (p.piece + kFar < q.piece || q.piece + kFar < p.piece) return {kInfinity, kInfinity, 0.0};
    const auto& pieces = to_.curve().pieces;
    const auto arcLength = [&](const Place& at) {
      return pieces[at.piece].start + at.t * (pieces[at.piece].end - pieces[at.piece].start);
    };
    const double from = arcLength(p), way = arcLength(q) - from;
    const auto value = [&](const PieceEnd& at, double radius, const PieceEnd& foot, const Place& where) {
      return (at.position - foot.position).norm() + radius - to_.radius(where);
    };
    const CurvePiece& curve = from_.curve().pieces[a.piece].curve;
    const bool forward = q.piece >= p.piece;

    Ceiling result{0.0, value(b.at, b.radius, {pieces[q.piece].curve, q.t}, q), 0.0};
    double share = 0.0;
    PieceEnd here = a.at;
    Place foot = p;
    struct Corner {
      double share, value, excess;
    };
    std::array<Corner, kFar + 1> corners;
    std::size_t count = 0;
    while (true) {
      const bool last = foot.piece == q.piece;
      const Place next = last ? q : Place{foot.piece, forward ? 1.0 : 0.0};
      const double next_share = last ? 1.0 : std::clamp((arcLength(next) - from) / way, share, 1.0);
      const double t = a.t + next_share * (b.t - a.t);
      const PieceEnd there = last ? b.at : PieceEnd(curve, t);
      const PieceEnd foot_here(pieces[foot.piece].curve, foot.t),
          foot_there(pieces[foot.piece].curve, next.t);
      ControlPoints gap = controlPoints(here, there, (next_share - share) * (b.t - a.t));
      const ControlPoints below = controlPoints(foot_here, foot_there, next.t - foot.t);
      for (std::size_t k = 0; k < gap.size(); ++k) gap[k] -= below[k];
      if (count == 0) result.start = value(here, a.radius, foot_here, foot);
      const double radius = a.radius + next_share * (b.radius - a.radius);
      corners[count++] = {next_share, value(there, radius, foot_there, next),
                          secondDerivativeBound(gap) / 8.0};
      if (last) break;
      share = next_share;
      here = there;
      foot = {forward ? foot.piece + 1 : foot.piece - 1, forward ? 0.0 : 1.0};
    }
    double above = 0.0;  // of the corner before, above the straight line
    for (std::size_t k = 0; k < count; ++k) {
      const double line = result.start + corners[k].share * (result.end - result.start);
      const double corner = corners[k].value - line;
      result.excess = std::max(result.excess, std::max(above, corner) + corners[k].excess);
      above = corner;
    }
    return result;
  }

  // Where the slope of the distance along the curve changes its sign, next to the best place found: the
  // place, and with it every derivative, is then exact and not only the distance.
  void polish() {
    const auto& pieces = from_.curve().pieces;
    const Place origin = best_.place;
    struct Slope {
      double value;
      Place place;
      NearestPlace::Found found;
    };
    // u: in widths of the best place's piece, from it
    const auto slope = [&](double u) {
      Place at{origin.piece, origin.t + u};
      const auto length = [&](std::size_t i) { return pieces[i].end - pieces[i].start; };
      double stretch = 1.0;
      while (at.t > 1.0 && at.piece + 1 < pieces.size()) {
        const double ratio = length(at.piece) / length(at.piece + 1);
        at = {at.piece + 1, (at.t - 1.0) * ratio};
        stretch *= ratio;
      }
      while (at.t < 0.0 && at.piece > 0) {
        const double ratio = length(at.piece) / length(at.piece - 1);
        at = {at.piece - 1, 1.0 + at.t * ratio};
        stretch *= ratio;
      }
      at.t = std::clamp(at.t, 0.0, 1.0);
      const CurvePiece& curve = pieces[at.piece].curve;
      const Vector3d position = curve.position(at.t);
      const NearestPlace::Found found = to_.find(position, best_.foot, kExact);
      const Vector3d away = position - to_.curve().position(found.place);
      const double far = away.norm();
      const double rise = far > 0.0 ? away.dot(curve.first(at.t)) / far : 0.0;
      return Slope{stretch * (rise + from_.radiusSlope(at.piece)), at, found};
    };
    double low = -around_, high = around_;
    Slope at_low = slope(low), at_high = slope(high);
    Slope here = slope(0.0);
    best_.value = here.found.lower_bound + from_.radius(origin);
    best_.foot = here.found.place;
    if (here.found.distance + to_.radius(here.found.place) < kExact) return;
    if (here.value > 0.0) {
      low = 0.0;
      at_low = here;
    } else {
      high = 0.0;
      at_high = here;
    }
    if (!(at_low.value > 0.0 && at_high.value < 0.0)) return;
    for (int i = 0; i < 100 && high - low > 1e-13; ++i) {
      // alternately the secant's zero, a little to the far side, and the middle
      double u = 0.5 * (low + high);
      if (i % 3 != 2) {
        u = low + (high - low) * at_low.value / (at_low.value - at_high.value);
        u = std::clamp(u, low + 1e-3 * (high - low), high - 1e-3 * (high - low));
      }
      here = slope(u);
      (here.value > 0.0 ? low : high) = u;
      (here.value > 0.0 ? at_low : at_high) = here;
    }
    const double value = here.found.lower_bound + from_.radius(here.place);
    constexpr double kFarApart = 1e-6;  // [m] feet of places that are next to each other
    const auto footOf = [&](const Slope& at) { return to_.curve().position(at.found.place); };
    best_.unique = (footOf(at_low) - footOf(at_high)).norm() < kFarApart;
    if (value >= best_.value - 1e-15) {
      best_.value = value;
      best_.place = here.place;
      best_.foot = here.found.place;
    }
  }

  const NearestPlace& from_;
  const NearestPlace& to_;
  double accuracy_, beat_ = -kInfinity;
  std::vector<Node> nodes_;
  std::vector<Interval> heap_;
  Result best_;
  double discarded_ = -kInfinity;  ///< the largest bound of an interval that was not worth a closer look
  double around_ = 1.0;
};

Hausdorff twoSided(const Centreline& a, const Centreline& b, double accuracy, bool surfaces) {
  if (!(accuracy > 0.0 && std::isfinite(accuracy))) {
    std::ostringstream text;
    text << "accuracy of a Hausdorff distance: " << accuracy << " m; expected a positive number";
    throw std::invalid_argument(text.str());
  }
  const NearestPlace on_a(a, surfaces), on_b(b, surfaces);
  const DirectedSearch::Result first = DirectedSearch(on_a, on_b, accuracy).run(-kInfinity);
  const DirectedSearch::Result second = DirectedSearch(on_b, on_a, accuracy).run(first.value);
  Hausdorff result;
  result.on_first = first.value >= second.value;
  const DirectedSearch::Result& larger = result.on_first ? first : second;
  result.distance = larger.value;
  result.place = larger.place;
  result.nearest = larger.foot;
  result.unique = larger.unique;
  result.error_bound = std::max(first.upper_bound, second.upper_bound) - result.distance;
  return result;
}

}  // namespace

Hausdorff curveHausdorff(const Centreline& a, const Centreline& b, double accuracy) {
  return twoSided(a, b, accuracy, false);
}

Hausdorff surfaceHausdorff(const Centreline& a, const Centreline& b, double accuracy) {
  return twoSided(a, b, accuracy, true);
}

}  // namespace cable_variation
