// Places that move with a minimum of the gap: where a cable crosses an edge, what is held there is not the
// section that lies on it but the edge, about which the cable rolls and over which it slides.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <cable_variation/equilibrium/discretisation/contact_system.h>

namespace cable_variation {

using Eigen::Vector3d;
using element::kNodeAt;
using element::kNodes;

namespace {

// A place follows the same face or edge as long as the cosine between directions is more than this.
constexpr double kSameDirection = 0.5;
// Of the second derivative that a straight tube across a straight edge has: what is flatter is no edge.
constexpr double kSharp = 0.3;
// Of a minimum that is no edge but a point: by this over the reach, in metres, the gap rises by kGapTolerance
// half a reach off.
constexpr double kBlunt = 8.0 * kGapTolerance;
// How far from a minimum that is judged, in reaches: faceted cylinders are smooth at this distance.
constexpr double kAside = 0.25;

// The second derivative of the centreline over the element.
Vector3d bendAt(const SpanConfiguration& span, std::size_t element, double at) {
  Vector3d bend = Vector3d::Zero();
  for (std::size_t a = 0; a < kNodes; ++a) {
    double weight = 0.0;
    for (std::size_t b = 0; b < kNodes; ++b) {
      for (std::size_t c = 0; c < kNodes; ++c) {
        if (a == b || a == c || b == c) continue;
        double product = 1.0 / ((kNodeAt[a] - kNodeAt[b]) * (kNodeAt[a] - kNodeAt[c]));
        for (std::size_t d = 0; d < kNodes; ++d) {
          if (d != a && d != b && d != c) product *= (at - kNodeAt[d]) / (kNodeAt[a] - kNodeAt[d]);
        }
        weight += product;
      }
    }
    bend += weight * span.positions[3 * element + a];
  }
  return bend;
}

}  // namespace

// Newton's method for the root of the gap's slope, between places where it falls and rises once they are
// known.
bool ContactSystem::toMinimum(std::size_t span, const SpanConfiguration& nodes, Place& place) const {
  constexpr int kSteps = 40;
  constexpr double kFound = 1e-10;  // of a reach
  constexpr double kStep = 0.3;     // of a reach, without a bracket
  constexpr double kFurthest = 1.5;
  const std::vector<double>& grid = spans_[span].grid;
  const PartContact& contact = harness_.contacts[place.held.front().contact];
  const Pose into = contact.pose.inverse();
  Place at = place;
  std::optional<double> low, high;  // shares where the gap falls and rises
  std::vector<SurfacePlace> found;
  for (int step = 0; step < kSteps; ++step) {
    const double reach = this->reach(place.held.front().contact, at);
    found.clear();
    contact.surface->placesNear(into * positionAt(nodes, at), 2.0 * reach, found);
    const SurfacePlace* on = nullptr;
    double best = kSameDirection;
    for (const SurfacePlace& each : found) {
      const double cosine = place.held.front().direction.dot(each.direction);
      if (cosine <= best) continue;
      best = cosine;
      on = &each;
    }
    if (on == nullptr) return false;
    const Vector3d tangent = into.orientation * tangentAt(nodes, at);
    const double speed = tangent.norm();
    const double slope = on->direction.dot(tangent) - at.radius_slope;
    const double second = tangent.dot(on->curvature * tangent) +
                          on->direction.dot(into.orientation * bendAt(nodes, at.element, at.at));
    (slope < 0.0 ? low : high) = at.share;
    const double width = grid[at.element + 1] - grid[at.element];
    const double longest = kStep * reach / speed;
    double way =
        second > 0.0 ? std::clamp(-slope / second, -longest, longest) : (slope < 0.0 ? longest : -longest);
    if (std::abs(way) * speed < kFound * reach) {
      const double least = at.blunt ? kBlunt / reach : kSharp;
      at.sharpness = second * reach > least * speed * speed ? second : 0.0;
      place = at;
      return true;
    }
    double share = at.share + way * width;
    if (low && high && !(share > std::min(*low, *high) && share < std::max(*low, *high)))
      share = 0.5 * (*low + *high);
    share = std::clamp(share, 0.0, 1.0);
    const double moved = (at.share - share) / width * speed;
    if (std::abs(moved) < kFound * reach) return false;  // an end of the span, or a kink
    Place next = makePlace(span, share, place.base);
    next.held = place.held;
    next.moves = place.moves;
    next.blunt = place.blunt;
    next.fresh = place.fresh;
    if ((positionAt(nodes, next) - positionAt(nodes, place)).norm() > kFurthest * reach) return false;
    at = std::move(next);
  }
  return false;
}

// Whether the gap rises to both sides of a minimum, some way off it.
bool ContactSystem::isSharp(std::size_t span, const SpanConfiguration& nodes, const Place& place) const {
  if (!(place.sharpness > 0.0)) return false;
  const std::size_t c = place.held.front().contact;
  const double reach = this->reach(c, place);
  const double speed = tangentAt(nodes, place).norm();
  const std::vector<double>& grid = spans_[span].grid;
  const double aside = kAside * reach / speed * (grid[place.element + 1] - grid[place.element]);
  if (place.share < aside || place.share > 1.0 - aside) return false;
  const Nearest here = nearest(c, nodes, place);
  for (const double side : {-aside, aside}) {
    const Nearest there = nearest(c, nodes, makePlace(span, place.share + side, false));
    if (there.found && there.gap - here.gap < kSharp * 0.5 * kAside * kAside * reach) return false;
  }
  return true;
}

void ContactSystem::moveMinima(std::size_t span, const SpanConfiguration& nodes) {
  std::vector<Place>& places = spans_[span].places;
  bool moved = false;
  for (Place& place : places) {
    if (!place.moves) continue;
    moved = true;
    if (!toMinimum(span, nodes, place)) place.sharpness = 0.0;
  }
  if (!moved) return;
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.share < b.share; });
}

// Whether the gaps of the next places to both sides that are as far off as sharpness is judged, as they were
// evaluated last, are nearly the same: a sharp minimum rises by four times as much to one of them at least,
// wherever between them it is. So none is looked for. Told only of a place that presses one way.
bool ContactSystem::liesFlat(std::size_t span, const SpanConfiguration& nodes, std::size_t place) const {
  const SpanPlaces& of = spans_[span];
  const Place& here = of.places[place];
  if (here.held.size() != 1) return false;
  const Held& held = here.held.front();
  const auto k = static_cast<std::size_t>(std::find(of.contacts.begin(), of.contacts.end(), held.contact) -
                                          of.contacts.begin());
  const Vector3d x = positionAt(nodes, here);
  const double reach = this->reach(held.contact, here);
  const double rise = 0.25 * kSharp * 0.5 * kAside * kAside * reach;
  const auto isAside = [&](const Place& at) { return (positionAt(nodes, at) - x).norm() >= kAside * reach; };
  const auto isAlike = [&](const Place& at) {
    const bool same_way = std::all_of(at.held.begin(), at.held.end(), [&](const Held& other) {
      return other.contact == held.contact && other.direction.dot(held.direction) > kSameDirection;
    });
    return same_way && !at.moves && std::abs(at.gap[k] - here.gap[k]) < rise;
  };
  const auto begin = of.places.begin() + static_cast<std::ptrdiff_t>(place);
  const auto after = std::find_if(begin, of.places.end(), isAside);
  const auto before = std::find_if(std::make_reverse_iterator(begin), of.places.rend(), isAside);
  return after != of.places.end() && before != of.places.rend() && isAlike(*after) && isAlike(*before);
}

void ContactSystem::letMove(std::size_t span, const SpanConfiguration& nodes) {
  constexpr double kSamePlace = 1e-3;  // reaches
  std::vector<Place> moving;
  const auto add = [&](const Place& place) {
    for (Place& known : moving) {
      const double reach = this->reach(place.held.front().contact, place);
      if (known.held.front().contact != place.held.front().contact ||
          known.held.front().direction.dot(place.held.front().direction) < kSameDirection ||
          (positionAt(nodes, known) - positionAt(nodes, place)).norm() > kSamePlace * reach)
        continue;
      known.held.front().now += place.held.front().now;
      known.held.front().known += place.held.front().known;
      return;
    }
    moving.push_back(place);
  };
  std::vector<Place> others;
  for (std::size_t p = 0; p < spans_[span].places.size(); ++p) {
    const Place& place = spans_[span].places[p];
    if (place.moves) {
      add(place);
      continue;
    }
    Place rest = place;
    rest.held.clear();
    for (const Held& held : place.held) {
      Place at = place;
      at.held = {held};
      at.base = false;
      at.moves = true;
      if (held.now > 0.0 && !liesFlat(span, nodes, p) && toMinimum(span, nodes, at) &&
          isSharp(span, nodes, at)) {
        add(at);
      } else {
        rest.held.push_back(held);
      }
    }
    others.push_back(std::move(rest));
  }
  if (moving.empty()) return;
  spans_[span].places = std::move(others);
  for (Place& place : moving) insert(span, std::move(place));
}

void ContactSystem::letMove(const Configuration& configuration) {
  for (std::size_t i = 0; i < spans_.size(); ++i) letMove(i, configuration.spans[i]);
}

void ContactSystem::setFollows(const Place& place, Pressing& pressing) const {
  if (!(pressing.sharpness > 0.0)) return;
  const std::vector<double>& grid = spans_[pressing.span].grid;
  const double width = grid[place.element + 1] - grid[place.element];
  for (std::size_t a = 0; a < kNodes; ++a) {
    pressing.follows[a] = (place.slope[a] / width * pressing.direction + place.weight[a] * pressing.along) /
                          std::sqrt(pressing.sharpness);
  }
}

}  // namespace cable_variation
