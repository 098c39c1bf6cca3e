// What presses in one point, where the gap has a blunt minimum along the cable: it rolls on and slides as a
// place that moves with the minimum does, and one that is held does not.
#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/contact_system.h>

namespace cable_variation {

namespace {

// Places of one run see the part in directions whose cosine is more than this.
constexpr double kSameDirection = 0.5;
// Places that press are no further from the minimum than where it has risen by so much [m], the larger of the
// two: by what gaps are held to, times this.
constexpr double kOfTolerance = 4.0;

}  // namespace

// Of places that press side by side, whether they are one point; then it moves from now on.
bool ContactSystem::letPointMove(const Configuration& configuration,
                                 const std::vector<const Pressing*>& run) {
  const Pressing& first = *run.front();
  const bool moves =
      std::any_of(run.begin(), run.end(), [](const Pressing* at) { return at->sharpness > 0.0; });
  if (moves) return false;
  SpanPlaces& span = spans_[first.span];
  std::size_t hardest = 0;
  double force = 0.0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    force += run[i]->force;
    if (run[i]->force > run[hardest]->force) hardest = i;
  }
  const auto isOf = [&](const Held& held, const Pressing& pressing) {
    const Pose& pose = harness_.contacts[pressing.contact].pose;
    return held.contact == pressing.contact &&
           held.direction.dot(pose.orientation.conjugate() * pressing.direction) > kSameDirection;
  };
  Place point = span.places[run[hardest]->place];
  const auto held = std::find_if(point.held.begin(), point.held.end(),
                                 [&](const Held& each) { return isOf(each, *run[hardest]); });
  if (held == point.held.end()) return false;
  point.held = {Held{held->contact, held->direction, force, force}};
  point.base = false;
  point.moves = point.blunt = has_points_ = true;
  const SpanConfiguration& nodes = configuration.spans[first.span];
  if (!toMinimum(first.span, nodes, point) || !(point.sharpness > 0.0)) return false;
  const double width = span.grid[point.element + 1] - span.grid[point.element];
  const double near = std::sqrt(2.0 * kOfTolerance * kGapTolerance / point.sharpness) * width;
  for (const Pressing* pressing : run) {
    if (std::abs(pressing->share - point.share) > near) return false;
  }
  for (const Pressing* pressing : run) {
    Place& place = span.places[pressing->place];
    place.held.erase(std::remove_if(place.held.begin(), place.held.end(),
                                    [&](const Held& each) { return isOf(each, *pressing); }),
                     place.held.end());
  }
  span.places.erase(std::remove_if(span.places.begin(), span.places.end(),
                                   [](const Place& place) { return place.moves && place.held.empty(); }),
                    span.places.end());
  insert(first.span, std::move(point));
  return true;
}

bool ContactSystem::isBesidePoint(std::size_t index, std::size_t contact, double share) const {
  const Span& of = topology_.spans[index];
  const double length = topology_.stations[of.right].arc_length - topology_.stations[of.left].arc_length;
  const std::vector<Place>& places = spans_[index].places;
  return std::any_of(places.begin(), places.end(), [&](const Place& place) {
    return place.blunt && place.held.front().contact == contact &&
           std::abs(place.share - share) * length <= reach(contact, place);
  });
}

// Runs of places that press the same thing, between which none is open.
std::vector<std::vector<const ContactSystem::Pressing*>> ContactSystem::pressingRuns() const {
  std::vector<std::vector<const Pressing*>> runs;
  for (const Pressing& at : pressing_) {
    const auto continues = [&](const std::vector<const Pressing*>& run) {
      const Pressing& last = *run.back();
      if (last.span != at.span || last.contact != at.contact || last.place == at.place) return false;
      if (last.direction.dot(at.direction) <= kSameDirection) return false;
      for (std::size_t place = last.place + 1; place < at.place; ++place) {
        if (!isClosed(at.contact, at.span, place, kTouching)) return false;
      }
      return true;
    };
    const auto run = std::find_if(runs.begin(), runs.end(), continues);
    if (run == runs.end()) {
      runs.push_back({&at});
    } else {
      run->push_back(&at);
    }
  }
  return runs;
}

bool ContactSystem::letPointsMove(const Configuration& configuration) {
  bool any = false, moved = true;
  evaluate(configuration);
  // each time one run less; places change their numbers
  for (std::size_t left = pressing_.size(); moved && left > 0; --left) {
    const auto runs = pressingRuns();
    moved = std::any_of(runs.begin(), runs.end(),
                        [&](const auto& run) { return letPointMove(configuration, run); });
    any = any || moved;
    if (moved) evaluate(configuration);
  }
  return any;
}

}  // namespace cable_variation
