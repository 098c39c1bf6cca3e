// Where the places are, and the forces that are known there.
#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/contact_system.h>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

// Places of the base are no further apart than this share of the tube's radius, as far as an element may have
// so many.
constexpr double kSpacing = 0.5;
constexpr double kFewest = 4.0, kMost = 24.0;
constexpr double kSame = 1e-9;  // of a span: two places that are one
// Of a minimum between places, to be worth a place of its own [m].
constexpr double kDeeper = 0.3 * kGapTolerance;

}  // namespace

void ContactSystem::forget() {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanPlaces& span = spans_[i];
    span.places.clear();
    if (span.contacts.empty()) continue;
    const Span& of = topology_.spans[i];
    const double left = topology_.stations[of.left].arc_length;
    const double length = topology_.stations[of.right].arc_length - left;
    for (std::size_t e = 0; e + 1 < span.grid.size(); ++e) {
      const double start = span.grid[e], share = span.grid[e + 1] - start;
      double smallest = INFINITY;
      for (const std::size_t c : span.contacts) {
        const double radius = profiles_[of.cable].at(left + (start + 0.5 * share) * length).radius;
        smallest = std::min(smallest, radius + harness_.contacts[c].stand_off);
      }
      const double count = std::clamp(std::ceil(share * length / (kSpacing * smallest)), kFewest, kMost);
      const bool last = e + 2 == span.grid.size();
      for (double j = 0.0; j < count + (last ? 1.0 : 0.0); ++j)
        span.places.push_back(makePlace(i, start + j / count * share, true));
    }
  }
  pressing_.clear();
  energy_ = worst_gap_ = 0.0;
}

void ContactSystem::insert(std::size_t index, Place place) {
  std::vector<Place>& places = spans_[index].places;
  const auto at = std::lower_bound(places.begin(), places.end(), place.share - kSame,
                                   [](const Place& other, double share) { return other.share < share; });
  if (at != places.end() && at->share < place.share + kSame && !at->moves && !place.moves) {
    at->held.insert(at->held.end(), place.held.begin(), place.held.end());
    return;
  }
  places.insert(at, std::move(place));
}

void ContactSystem::take(const ContactSystem& other) {
  forget();
  softness_ = other.softness_;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (const Place& place : other.spans_[i].places) {
      if (place.base && place.held.empty()) continue;
      Place here = makePlace(i, place.share, false);
      here.held = place.held;
      here.moves = place.moves;
      here.blunt = place.blunt;
      has_points_ = has_points_ || place.blunt;
      insert(i, std::move(here));
    }
  }
}

void ContactSystem::watch(std::size_t cable, double arc_length, const Configuration& configuration) {
  for (const std::size_t i : topology_.cable_spans[cable]) {
    const double start = arcLength(i, 0.0, configuration), end = arcLength(i, 1.0, configuration);
    if (arc_length < start || arc_length > end) continue;
    insert(i, makePlace(i, (arc_length - start) / (end - start), false));
    return;
  }
}

ContactSystem::Nearest ContactSystem::nearest(std::size_t contact, const SpanConfiguration& nodes,
                                              const Place& place) const {
  const PartContact& of = harness_.contacts[contact];
  const double reach = this->reach(contact, place);
  std::vector<SurfacePlace> found;
  of.surface->placesNear(of.pose.inverse() * positionAt(nodes, place), 1.5 * reach, found);
  if (found.empty()) return {};
  const SurfacePlace& on =
      *std::min_element(found.begin(), found.end(),
                        [](const SurfacePlace& a, const SurfacePlace& b) { return a.distance < b.distance; });
  const Vector3d direction = of.pose.orientation * on.direction;
  return {on.distance - reach, direction.dot(tangentAt(nodes, place)) - place.radius_slope, true};
}

// A minimum of the gap inside, where it falls at a and rises at b, if it is below both ends and below zero.
std::optional<ContactSystem::Place> ContactSystem::minimumBetween(std::size_t span, std::size_t contact,
                                                                  const SpanConfiguration& nodes,
                                                                  const Place& a, const Place& b,
                                                                  const Nearest& left,
                                                                  const Nearest& right) const {
  constexpr int kSteps = 40;
  constexpr double kNarrow = 1e-6;  // of the way between
  if (!left.found || !right.found || !(left.slope < 0.0) || !(right.slope > 0.0)) return std::nullopt;
  double low = a.share, high = b.share;
  double low_slope = left.slope, high_slope = right.slope;
  Place best = a;
  double gap = INFINITY;
  for (int step = 0; step < kSteps && high - low > kNarrow * (b.share - a.share); ++step) {
    // regula falsi, every second time a bisection
    double t = low_slope / (low_slope - high_slope);
    t = step % 2 == 0 ? std::clamp(t, 0.01, 0.99) : 0.5;
    const Place middle = makePlace(span, low + t * (high - low), false);
    const Nearest at = nearest(contact, nodes, middle);
    if (!at.found) return std::nullopt;
    if (at.gap < gap) {
      gap = at.gap;
      best = middle;
    }
    if (at.slope == 0.0) break;
    (at.slope < 0.0 ? low : high) = middle.share;
    (at.slope < 0.0 ? low_slope : high_slope) = at.slope;
  }
  if (!(gap < -kDeeper) || !(gap < std::min(left.gap, right.gap) - kDeeper)) return std::nullopt;
  return best;
}

bool ContactSystem::holds() const {
  return std::any_of(spans_.begin(), spans_.end(), [](const SpanPlaces& span) {
    return std::any_of(span.places.begin(), span.places.end(),
                       [](const Place& place) { return !place.held.empty(); });
  });
}

void ContactSystem::keepForces(const Configuration& configuration) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    letMove(i, configuration.spans[i]);
    SpanPlaces& span = spans_[i];
    for (Place& place : span.places) {
      for (Held& held : place.held) held.known = held.now;
      place.held.erase(std::remove_if(place.held.begin(), place.held.end(),
                                      [](const Held& held) { return held.known <= 0.0; }),
                       place.held.end());
    }
    span.places.erase(
        std::remove_if(span.places.begin(), span.places.end(),
                       [](const Place& place) { return !place.base && !place.fresh && place.held.empty(); }),
        span.places.end());
  }
}

bool ContactSystem::findMinima(const Configuration& configuration) {
  bool found = false;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const SpanConfiguration& nodes = configuration.spans[i];
    for (std::size_t k = 0; k < spans_[i].contacts.size(); ++k) {
      const std::size_t c = spans_[i].contacts[k];
      const std::vector<CableStretch> stretches = skipped(harness_.contacts[c], configuration);
      std::vector<Place> minima;
      const std::vector<Place>& places = spans_[i].places;
      std::optional<Nearest> known;  // of the place before the next
      for (std::size_t j = 0; j + 1 < places.size(); ++j) {
        const Place &a = places[j], &b = places[j + 1];
        const double near = 1.5 * reach(c, a);
        if (a.clear[k] > near && b.clear[k] > near) {
          known.reset();
          continue;
        }
        const Nearest left = known ? *known : nearest(c, nodes, a), right = nearest(c, nodes, b);
        known = right;
        const auto minimum = minimumBetween(i, c, nodes, a, b, left, right);
        if (!minimum || !counts(stretches, arcLength(i, minimum->share, configuration))) continue;
        if (has_points_ && isBesidePoint(i, c, minimum->share)) continue;
        minima.push_back(*minimum);
      }
      for (Place& minimum : minima) {
        insert(i, std::move(minimum));
        found = true;
      }
    }
  }
  return found;
}

}  // namespace cable_variation
