#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/wall_timer.h>

#include <cable_variation/scene/design.h>
#include <ros_interface/interaction/drag_markers.h>
#include <ros_interface/interaction/drag_menu.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// Clips and components as interactive markers: a click on one opens its arrows and rings, and while it is
/// dragged the design in force follows, and with it the cables. What was dragged is put back, or set as
/// design, by its menu; a clip is added where a cable or component was clicked on.
class DragServer {
 public:
  /// All must outlive this. @param analyse shows the effect of some design variables, by name; none: of all
  DragServer(ros::NodeHandle& node, SolverContext& context,
             std::function<void(const std::vector<std::string>&)> analyse);
  ~DragServer();

  /// Things may be elsewhere now, or others.
  void contextChanged();

 private:
  using Feedback = interactive_markers::MenuHandler::FeedbackConstPtr;
  /// What a clip's mount or a component's shift was, before it was dragged.
  using Before = std::optional<cable_variation::Pose>;
  struct Shown {
    cable_variation::Pose pose;
    bool open = false, changed = false;
  };

  void hear(const Feedback& feedback);
  void follow();  // the newest pose of what is dragged
  void edit(const DragTarget& target, const std::function<void(cable_variation::Design&)>& change);
  void remember(const DragTarget& target);
  void setAsDesign(const DragTarget& target);
  void putBack(const DragTarget& target);
  void reset(const DragTarget& target);
  void addClip(const DragTarget& target, const Eigen::Vector3d& point, const std::string& type);
  void addCable(const DragTarget& target, const Eigen::Vector3d& point);
  std::vector<std::string> variablesOf(const DragTarget& target) const;
  void refresh();
  void show(const DragTarget& target, const cable_variation::Pose& pose, double size);
  void showCables();
  void hideCables();

  SolverContext& context_;
  std::function<void(const std::vector<std::string>&)> analyse_;
  interactive_markers::InteractiveMarkerServer server_;
  std::map<DragTarget::Kind, interactive_markers::MenuHandler> menus_;
  std::map<std::string, Shown> shown_;    // by marker
  std::set<std::string> cables_shown_;    // markers
  std::set<std::string> open_;            // markers
  std::map<std::string, Before> before_;  // by marker: dragged, and not yet set as design
  std::string dragged_;                   // marker; empty: none
  cable_variation::Pose wanted_;          // of it, in the world
  bool woken_ = false;                    // follow() is about to be called
  std::size_t loads_ = 0;
  bool outdated_ = true;  // the markers are
  int calm_ = 0;          // ticks since the context has changed
  ros::WallTimer tick_;
};

}  // namespace cable_variation_ros
