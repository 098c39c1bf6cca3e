#include <ros_interface/live/shape_watch.h>

#include <cable_variation/scene/measure.h>
#include <cable_variation/util/quantity.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;
using cable_variation::EquilibriumStatus;
using cable_variation::Measure;
using cable_variation::MeasureValue;
using cable_variation::shortNumber;

namespace {

CableEvent eventAt(const SolverContext& context, std::uint8_t kind) {
  CableEvent event;
  event.header.stamp = context.stamp();
  event.header.frame_id = kWorldFrame;
  event.kind = kind;
  return event;
}

CableEvent snapOf(const SolverContext& context, const cable_variation::ShapeJump& jump) {
  CableEvent event = eventAt(context, CableEvent::SNAPPED);
  event.cable = context.harness().cables[jump.cable].name;
  event.arc_length = jump.arc_length;
  event.from_value = jump.energy_before;
  event.to_value = jump.energy_after;
  event.distance = jump.distance;
  event.text = "cable '" + event.cable + "' snapped over by " + shortNumber(1e3 * jump.distance) + " mm at " +
               shortNumber(1e3 * jump.arc_length) + " mm of its length: the equilibrium that it was in ended";
  return event;
}

/// What clips did: the whole change is told with each of them.
void tellClips(const SolverContext& context, std::vector<CableEvent>& events) {
  const cable_variation::AttachedClips& attached = *context.lastAttachment();
  const std::vector<cable_variation::Clip>& clips = context.harness().clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].attached == context.attachedBefore()[i]) continue;
    events.push_back(eventAt(context, clips[i].attached ? CableEvent::CLIP_CLOSED : CableEvent::CLIP_OPENED));
    CableEvent& event = events.back();
    event.clip = clips[i].name;
    event.cable = context.harness().cables[attached.cable].name;
    event.arc_length = attached.arc_length;
    event.from_value = attached.energy_before;
    event.to_value = attached.followed.equilibrium.energy.total();
    event.distance = attached.distance;
    const std::string held = context.harness().cables[clips[i].cable].name;
    event.text = "clip '" + event.clip + (clips[i].attached ? "' took hold of" : "' let go of") + " cable '" +
                 held + "'; cable '" + event.cable + "' went by " + shortNumber(1e3 * event.distance) +
                 " mm at " + shortNumber(1e3 * event.arc_length) + " mm of its length";
  }
}

std::string limitsOf(const Measure& measure) {
  std::string text;
  if (measure.lower) text += ", at least " + shortNumber(*measure.lower);
  if (measure.upper) text += ", at most " + shortNumber(*measure.upper);
  return text;
}

}  // namespace

std::vector<CableEvent> ShapeWatch::eventsOf(const SolverContext& context,
                                             const std::vector<MeasureValue>& measured) {
  std::vector<CableEvent> events;
  if (context.lastAttachment()) tellClips(context, events);
  compareEquilibria(context, events);
  compareLimits(context, measured, events);
  last_ = events;
  return events;
}

void ShapeWatch::compareEquilibria(const SolverContext& context, std::vector<CableEvent>& events) {
  if (context.lastJump()) events.push_back(snapOf(context, *context.lastJump()));
  const cable_variation::Equilibrium& equilibrium = context.equilibrium();
  const bool converged = equilibrium.converged();
  if (converged != converged_) {
    const std::uint8_t kind = converged ? CableEvent::EQUILIBRIUM_BACK
                              : equilibrium.status == EquilibriumStatus::impossible
                                  ? CableEvent::OVERSTRETCHED
                                  : CableEvent::EQUILIBRIUM_LOST;
    events.push_back(eventAt(context, kind));
    events.back().text = converged ? "there is an equilibrium again"
                                   : std::string(toString(equilibrium.status)) + ": " + equilibrium.message;
  }
  converged_ = converged;
}

void ShapeWatch::compareLimits(const SolverContext& context, const std::vector<MeasureValue>& measured,
                               std::vector<CableEvent>& events) {
  const cable_variation::Scene& scene = context.design().scene;
  const std::vector<Measure>& measures = scene.measures;
  if (source_ != scene.source || known_.size() != measures.size()) known_.clear();
  source_ = scene.source;
  if (measured.empty()) return;
  std::vector<Known> now;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    now.push_back({measured[i].value, withinLimits(measures[i], measured[i].value)});
    const Known before = known_.empty() ? Known{now[i].value, true} : known_[i];
    if (now[i].within == before.within) continue;
    events.push_back(eventAt(context, now[i].within ? CableEvent::LIMIT_KEPT : CableEvent::LIMIT_BROKEN));
    CableEvent& event = events.back();
    event.measure = measures[i].name;
    event.from_value = before.value;
    event.to_value = now[i].value;
    event.text = "measure '" + measures[i].name + "' is " + shortNumber(now[i].value) + " " +
                 measures[i].unit +
                 (now[i].within ? " and keeps its limits again (" : " and breaks its limits (") +
                 measures[i].unit + limitsOf(measures[i]) + ")";
  }
  known_ = std::move(now);
}

}  // namespace cable_variation_ros
