#include <ros_interface/live/tf_watch.h>

#include <algorithm>
#include <iterator>

#include <cable_variation/util/quantity.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;
using cable_variation::shortNumber;

void TfWatch::expect(const std::string& component, const ros::Time& now) {
  const auto [source, is_new] = sources_.emplace(component, Source());
  if (is_new) source->second.arrived = now;
}

void TfWatch::saw(const std::string& component, const ros::Time& stamp, const ros::Time& now) {
  Source& source = sources_[component];
  if (source.seen && source.stamp == stamp) return;
  source.seen = true;
  source.stamp = stamp;
  source.arrived = now;
}

double TfWatch::age(const Source& source, const ros::Time& now) const {
  // of numbers: a ros::Duration of more than 68 years throws
  const double silent = now.toSec() - source.arrived.toSec();
  return source.seen ? std::max(silent, now.toSec() - source.stamp.toSec()) : silent;
}

std::string TfWatch::textOf(const std::string& component, const Source& source, const ros::Time& now) const {
  const std::string who = "component '" + component + "'";
  if (!source.seen) return who + " is driven by tf and has not been on it";
  return who + ": its newest tf is " + shortNumber(age(source, now)) +
         " s old, more than ~tf_timeout allows (" + shortNumber(timeout_) +
         " s); it is taken to be where it was";
}

std::vector<CableEvent> TfWatch::eventsAt(const ros::Time& now) {
  std::vector<CableEvent> events;
  for (auto& [component, source] : sources_) {
    const double old = age(source, now);
    const bool late = old > timeout_;
    if (late == source.late) continue;
    source.late = late;
    CableEvent event;
    event.header.stamp = source.seen ? source.stamp : now;
    event.kind = late ? CableEvent::TF_LATE : CableEvent::TF_BACK;
    event.component = component;
    event.text =
        late ? textOf(component, source, now) : "component '" + component + "' is on tf in time again";
    event.to_value = late ? old : 0.0;
    events.push_back(event);
  }
  return events;
}

std::vector<std::string> TfWatch::late(const ros::Time& now) const {
  std::vector<std::string> texts;
  for (const auto& [component, source] : sources_) {
    if (source.late) texts.push_back(textOf(component, source, now));
  }
  return texts;
}

void TfWatch::keepOnly(const std::set<std::string>& components) {
  for (auto source = sources_.begin(); source != sources_.end();)
    source = components.count(source->first) != 0 ? std::next(source) : sources_.erase(source);
}

}  // namespace cable_variation_ros
