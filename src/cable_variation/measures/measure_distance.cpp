#include <cable_variation/measures/measure_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include <Eigen/Geometry>

#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/measures/joint_between.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kEqual = 1e-6;     // [m] two distances that differ less count as the same
constexpr double kOnALimit = 1e-9;  // [m] from the end of a skipped stretch

const Pose& poseOf(const MeasureContext& context, const std::string& component) {
  const auto pose = context.at.components.find(component);
  if (pose == context.at.components.end()) {
    throw std::invalid_argument("measures: the pose of component '" + component + "' is not given");
  }
  return pose->second;
}

// Clips of a cable around which it is not measured.
template <class Visit>
void visitSkippedClips(const MeasureContext& context, const Measure& measure, std::size_t cable,
                       const Visit& visit) {
  if (!(measure.skip_near_clips > 0.0)) return;
  const Component& component = context.scene.components[*measure.component];
  for (std::size_t i = 0; i < context.at.harness.clips.size(); ++i) {
    const Clip& clip = context.at.harness.clips[i];
    if (clip.attached && clip.cable == cable && ridesOn(context.scene, i, component))
      visit(i, context.at.equilibrium.clip_reactions[i].arc_length);
  }
}

double valueIn(const std::vector<std::pair<std::size_t, double>>& list, std::size_t index) {
  for (const auto& [at, value] : list) {
    if (at == index) return value;
  }
  return 0.0;
}

MeasureValue nothingToMeasure() {
  MeasureValue none;
  none.value = std::numeric_limits<double>::infinity();
  none.note = "all of it is skipped";
  return none;
}

MeasureValue fromPair(const MeasureContext& context, std::size_t cable, const ClosestPair& pair) {
  MeasureValue value = measureAt(context, cable, pair.place, pair.distance);
  value.point = pair.on_cable - context.cables[cable].line().radius(pair.place) * pair.direction;
  value.has_other = true;
  value.other = pair.on_other;
  value.trace.direction = pair.direction;
  return value;
}

// What to know of a value below none, and of one at a part that is open.
std::string depthNote(const std::string& name, const ClosestPair& pair) {
  const bool open = pair.side != ClosestPair::Side::known;
  std::ostringstream note;
  note.precision(2);
  if (pair.is_depth) {
    note << "the centreline enters '" << name
         << "': minus the depth of its deepest point and the radius there";
    if (open && std::round(pair.winding) != 0.0) {
      note << "; '" << name << "' is open, its winding number " << pair.winding
           << " tells that this is inside";
    } else if (open) {
      note << "; other shells of '" << name << "' are open";
    }
  } else if (pair.contact == ClosestPair::Contact::pierced) {
    note << "the centreline " << (open ? "pierces or touches the surface of '" : "touches '") << name
         << (open ? "', which is open: minus the radius, as the depth of what bounds no inside is not known"
                  : "' and goes no deeper: minus the radius");
  } else if (open) {
    note << "'" << name << "' is open";
  }
  return note.str();
}

// The change of the distance per t of a place on `view`, the closest points' direction being `direction`.
double slopeAt(const CableView& view, const Place& place, const Vector3d& direction) {
  const Centreline::Piece& piece = view.line().pieces[place.piece];
  return direction.dot(piece.curve.first(place.t)) - (piece.end_radius - piece.start_radius);
}

}  // namespace

MeasureValue componentDistanceValue(const MeasureContext& context, const Measure& measure,
                                    const std::vector<MeasuredBody>& bodies, const MeasureValue* near,
                                    const std::vector<PartVicinity>& vicinities) {
  const std::size_t cables = measure.cables.size();
  std::vector<std::optional<ClosestPair>> pairs(bodies.size() *
                                                cables);  // of body k / cables and cable k % cables
  const auto name_at = [&](std::size_t k) -> const std::string& {
    return context.scene.components[bodies[k / cables].component].name;
  };
  const bool known = near != nullptr && near->trace.pairs.size() == pairs.size();
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (known) {
    // the closest of a similar shape first: the others need only be looked at as far as that
    const auto before = [&](std::size_t k) {
      const auto& pair = near->trace.pairs[k];
      return pair ? pair->distance : std::numeric_limits<double>::infinity();
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return before(a) < before(b); });
  }
  std::size_t smallest = pairs.size();
  for (const std::size_t k : order) {
    const std::size_t cable = measure.cables[k % cables];
    std::vector<SkippedStretch> skipped;
    visitSkippedClips(context, measure, cable, [&](std::size_t, double at) {
      skipped.push_back({at - measure.skip_near_clips, at + measure.skip_near_clips});
    });
    DistanceSearch search;
    if (known) {
      const std::optional<ClosestPair>& pair = near->trace.pairs[k];
      if (pair && pair->place.piece < context.cables[cable].pieces().size()) search.near = &*pair;
      if (k < vicinities.size()) search.vicinity = &vicinities[k];
      if (smallest < pairs.size()) search.limit = pairs[smallest]->distance;
    }
    pairs[k] = distance(context.cables[cable].line(), *bodies[k / cables].part, poseOf(context, name_at(k)),
                        skipped, kEqual, search);
    if (!pairs[k]) continue;
    if (smallest == pairs.size() || pairs[k]->distance < pairs[smallest]->distance) smallest = k;
  }
  if (smallest == pairs.size()) return nothingToMeasure();
  const ClosestPair& closest = *pairs[smallest];
  MeasureValue value = fromPair(context, measure.cables[smallest % cables], closest);
  value.trace.component = bodies[smallest / cables].component;
  value.note = depthNote(name_at(smallest), closest);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!pairs[k] || pairs[k]->side != ClosestPair::Side::undecided) continue;
    value.undecided = true;
    value.note +=
        (value.note.empty() ? "" : "; ") + undecidedNote(name_at(k), pairs[k]->side, pairs[k]->winding);
    break;
  }
  bool shared = closest.runner_up < closest.distance + kEqual;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    shared = shared || (k != smallest && pairs[k] && pairs[k]->distance < closest.distance + kEqual);
  if (shared) markAsShared(value, "as close at another place");
  value.trace.pairs = std::move(pairs);
  return value;
}

double componentDistanceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                             const MeasureRates& rates) {
  if (!value.has_place) return 0.0;
  const CableView& view = context.cables[value.cable];
  const CableRates cable = rates.cable(value.cable);
  const Place& place = value.trace.place;
  const PlaceRate at = view.rate(place, cable);
  Vector3d part = Vector3d::Zero();
  for (const auto& [index, frame] : rates.design.components) {
    if (index != value.trace.component) continue;
    const Pose& pose = poseOf(context, context.scene.components[index].name);
    part = frame.translation + frame.rotation.cross(value.other - pose.position);
  }
  double rate = value.trace.direction.dot(at.position - part) - at.radius;
  visitSkippedClips(context, measure, value.cable, [&](std::size_t clip, double held) {
    if (std::abs(std::abs(value.arc_length - held) - measure.skip_near_clips) > kOnALimit) return;
    rate += slopeAt(view, place, value.trace.direction) *
            view.shareRate(place, cable, rates.equilibrium.clip_reactions[clip].arc_length);
  });
  return rate;
}

MeasureValue cableDistanceValue(const MeasureContext& context, const Measure& measure) {
  std::optional<MeasureValue> closest;
  bool shared = false;
  for (const std::size_t cable : measure.cables) {
    for (const std::size_t other : measure.other_cables) {
      if (cable == other) continue;
      const auto joint = jointBetween(context.at.harness, cable, other);
      const auto pair = distance(
          context.cables[cable].line(), context.cables[other].line(),
          joint ? std::optional<JoinedAt>(joint->at(measure.skip_near_joints)) : std::nullopt, kEqual);
      if (!pair || (closest && pair->distance >= closest->value + kEqual)) continue;
      shared = closest && pair->distance > closest->value - kEqual;
      if (closest && pair->distance >= closest->value) continue;
      shared = shared || pair->runner_up < pair->distance + kEqual;
      closest = fromPair(context, cable, *pair);
      closest->trace.other_cable = other;
      closest->trace.other_place = *pair->other_place;
      closest->other += context.cables[other].line().radius(*pair->other_place) * pair->direction;
      if (pair->contact == ClosestPair::Contact::pierced) closest->note = "the centrelines meet";
    }
  }
  if (!closest) return nothingToMeasure();
  if (shared) markAsShared(*closest, "as close at another place");
  return *closest;
}

double cableDistanceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                         const MeasureRates& rates) {
  if (!value.has_place) return 0.0;
  const MeasureValue::Trace& trace = value.trace;
  const CableView &view = context.cables[value.cable], &other_view = context.cables[trace.other_cable];
  const CableRates cable = rates.cable(value.cable), other_cable = rates.cable(trace.other_cable);
  const PlaceRate at = view.rate(trace.place, cable);
  const PlaceRate other = other_view.rate(trace.other_place, other_cable);
  double rate = trace.direction.dot(at.position - other.position) - at.radius - other.radius;

  const auto joint = jointBetween(context.at.harness, value.cable, trace.other_cable);
  if (!joint) return rate;
  const double to_joint = value.arc_length - joint->on_first;
  const double from_joint = other_view.arcLength(trace.other_place) - joint->on_second;
  if (std::abs(to_joint) + std::abs(from_joint) > measure.skip_near_joints + kOnALimit) return rate;
  // The shortest way that counts: the places keep it. Each stays as far from the joint as it is, unless it
  // is at an end of its cable; then it stays there and the other makes up for it.
  const double parent = valueIn(rates.design.harness.parent_arc_lengths, joint->joint);
  const double child = valueIn(rates.design.harness.child_arc_lengths, joint->joint);
  const double joint_here = joint->parent_first ? parent : child;
  const double joint_there = joint->parent_first ? child : parent;
  double here = joint_here, there = joint_there;
  const double signs = (to_joint < 0.0 ? -1.0 : 1.0) * (from_joint < 0.0 ? -1.0 : 1.0);
  if (other_view.isEnd(trace.other_place)) {
    there = other.arc_length;
    here -= signs * (there - joint_there);
  } else if (view.isEnd(trace.place)) {
    here = at.arc_length;
    there -= signs * (here - joint_here);
  }
  rate += slopeAt(view, trace.place, trace.direction) * view.shareRate(trace.place, cable, here);
  rate += slopeAt(other_view, trace.other_place, -trace.direction) *
          other_view.shareRate(trace.other_place, other_cable, there);
  return rate;
}

}  // namespace cable_variation
