#include <ros_interface/live/shape_watch.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/event_conversion.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;
using cable_variation::MeasureValue;
using cable_variation::ShapeEvent;

std::vector<CableEvent> ShapeWatch::eventsOf(const SolverContext& context,
                                             const std::vector<MeasureValue>& measured) {
  std::vector<ShapeEvent> events;
  if (context.lastAttachment())
    events = clipEvents(context.attachedBefore(), context.harness(), *context.lastAttachment());
  if (context.lastJump()) events.push_back(snapEvent(context.harness(), *context.lastJump()));
  const bool no_cable = context.harness().cables.empty();  // then nothing is lost
  if (!no_cable) {
    if (const auto event = equilibriumEvent(converged_, context.equilibrium())) events.push_back(*event);
  }
  converged_ = no_cable || context.equilibrium().converged();

  const cable_variation::Scene& scene = context.design().scene;
  if (source_ != scene.source) limits_ = {};
  source_ = scene.source;
  if (!measured.empty()) {
    for (ShapeEvent& event : limits_.compare(scene.measures, measured)) events.push_back(std::move(event));
  }
  last_.clear();
  for (const ShapeEvent& event : events) last_.push_back(toMessage(event, context.stamp()));
  return last_;
}

}  // namespace cable_variation_ros
