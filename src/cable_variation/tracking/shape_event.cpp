#include <cable_variation/tracking/shape_event.h>

#include <cmath>

#include <cable_variation/util/display_unit.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

std::string millimetreText(double length) { return shortNumber(1e3 * length) + " mm"; }

std::string limitsOf(const Measure& measure) {
  std::string text;
  if (measure.lower) text += "at least " + displayValue(*measure.lower, measure.unit);
  if (measure.upper)
    text += (text.empty() ? "at most " : ", at most ") + displayValue(*measure.upper, measure.unit);
  return text;
}

ShapeEvent limitEvent(const Measure& measure, double before, double now, bool within) {
  ShapeEvent event;
  event.kind = within ? ShapeEvent::Kind::limit_kept : ShapeEvent::Kind::limit_broken;
  event.measure = measure.name;
  event.from_value = before;
  event.to_value = now;
  event.text = "measure '" + measure.name + "' is " + displayValue(now, measure.unit) +
               (within ? " and keeps its limits again (" : " and breaks its limits (") + limitsOf(measure) +
               ")";
  return event;
}

}  // namespace

bool isFault(ShapeEvent::Kind kind) {
  using Kind = ShapeEvent::Kind;
  return kind == Kind::snapped || kind == Kind::equilibrium_lost || kind == Kind::overstretched ||
         kind == Kind::limit_broken || kind == Kind::clip_refused;
}

std::string shortText(const ShapeEvent& event) {
  using Kind = ShapeEvent::Kind;
  switch (event.kind) {
    case Kind::snapped:
      return "snap";
    case Kind::equilibrium_lost:
      return "no equilibrium";
    case Kind::overstretched:
      return "overstretched";
    case Kind::equilibrium_back:
      return "equilibrium again";
    case Kind::limit_broken:
      return event.measure + " out of its limits";
    case Kind::limit_kept:
      return event.measure + " within its limits";
    case Kind::clip_closed:
      return event.clip + " closed";
    case Kind::clip_opened:
      return event.clip + " opened";
    case Kind::clip_refused:
      break;
  }
  return event.clip + " refused";
}

ShapeEvent snapEvent(const Harness& harness, const ShapeJump& jump) {
  ShapeEvent event;
  event.kind = ShapeEvent::Kind::snapped;
  event.cable = harness.cables[jump.cable].name;
  event.arc_length = jump.arc_length;
  event.from_value = jump.energy_before;
  event.to_value = jump.energy_after;
  event.distance = jump.distance;
  event.text = "cable '" + event.cable + "' snapped over by " + millimetreText(jump.distance) + " at " +
               millimetreText(jump.arc_length) + " of its length: the equilibrium that it was in ended";
  return event;
}

std::vector<ShapeEvent> clipEvents(const std::vector<bool>& before, const Harness& harness,
                                   const AttachedClips& attached) {
  std::vector<ShapeEvent> events;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    if (clip.attached == before[i]) continue;
    ShapeEvent event;
    event.kind = clip.attached ? ShapeEvent::Kind::clip_closed : ShapeEvent::Kind::clip_opened;
    event.clip = clip.name;
    event.cable = harness.cables[attached.cable].name;
    event.arc_length = attached.arc_length;
    event.from_value = attached.energy_before;
    event.to_value = attached.followed.equilibrium.energy.total();
    event.distance = attached.distance;
    event.text = "clip '" + clip.name + (clip.attached ? "' took hold of" : "' let go of") + " cable '" +
                 harness.cables[clip.cable].name + "'; cable '" + event.cable + "' went by " +
                 millimetreText(event.distance) + " at " + millimetreText(event.arc_length) +
                 " of its length";
    events.push_back(event);
  }
  return events;
}

std::optional<ShapeEvent> equilibriumEvent(bool before, const Equilibrium& equilibrium) {
  if (equilibrium.converged() == before) return std::nullopt;
  ShapeEvent event;
  if (equilibrium.converged()) {
    event.kind = ShapeEvent::Kind::equilibrium_back;
    event.text = "there is an equilibrium again";
  } else {
    event.kind = equilibrium.status == EquilibriumStatus::impossible ? ShapeEvent::Kind::overstretched
                                                                     : ShapeEvent::Kind::equilibrium_lost;
    event.text = std::string(toString(equilibrium.status)) + ": " + equilibrium.message;
  }
  return event;
}

std::vector<ShapeEvent> LimitWatch::compare(const std::vector<Measure>& measures,
                                            const std::vector<MeasureValue>& values) {
  std::vector<ShapeEvent> events;
  std::vector<Known> now;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const double value = values[i].value;
    const Known before = known_.size() == measures.size() ? known_[i] : Known{value, true};
    if (std::isnan(value)) {  // not known: what was known of it stands
      now.push_back(before);
      continue;
    }
    now.push_back({value, withinLimits(measures[i], value)});
    if (now[i].within != before.within)
      events.push_back(limitEvent(measures[i], before.value, now[i].value, now[i].within));
  }
  known_ = std::move(now);
  return events;
}

}  // namespace cable_variation
