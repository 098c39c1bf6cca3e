#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <ros/time.h>

#include <cable_variation/CableEvent.h>

namespace cable_variation_ros {

/// Whether the tf of components comes in time.
class TfWatch {
 public:
  /// @param timeout how old tf may be [s]
  explicit TfWatch(double timeout) : timeout_(timeout) {}

  /// A component that has to be on tf, seen or not yet.
  void expect(const std::string& component, const ros::Time& now);
  /// tf has the component with this stamp.
  void saw(const std::string& component, const ros::Time& stamp, const ros::Time& now);
  /// Late ones and those that are back, each once.
  std::vector<cable_variation::CableEvent> eventsAt(const ros::Time& now);
  /// What is late now, for a person: one sentence each.
  std::vector<std::string> late(const ros::Time& now) const;
  /// Forgets all, as the clock was set back.
  void restart() { sources_.clear(); }
  /// Forgets components that are not among `components`: the scene is another one.
  void keepOnly(const std::set<std::string>& components);

 private:
  struct Source {
    bool seen = false;
    ros::Time stamp;    // newest; it may lie ahead
    ros::Time arrived;  // the first time that this stamp was seen; before any: expected since
    bool late = false;
  };
  double age(const Source& source, const ros::Time& now) const;  // [s]
  std::string textOf(const std::string& component, const Source& source, const ros::Time& now) const;

  double timeout_;
  std::map<std::string, Source> sources_;
};

}  // namespace cable_variation_ros
