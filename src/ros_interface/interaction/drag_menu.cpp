#include <ros_interface/interaction/drag_menu.h>

#include <cable_variation/harness/clip_preset.h>

namespace cable_variation_ros {

using interactive_markers::MenuHandler;
using Feedback = interactive_markers::MenuHandler::FeedbackConstPtr;

namespace {

void addAction(MenuHandler& menu, const char* title, const DragActions::OnTarget& action) {
  menu.insert(title, [action](const Feedback& feedback) { action(dragTargetOf(feedback->marker_name)); });
}

Eigen::Vector3d pointOf(const visualization_msgs::InteractiveMarkerFeedback& feedback) {
  const geometry_msgs::Point& point =
      feedback.mouse_point_valid ? feedback.mouse_point : feedback.pose.position;
  return {point.x, point.y, point.z};
}

}  // namespace

MenuHandler dragMenu(DragTarget::Kind kind, const DragActions& actions) {
  MenuHandler menu;
  addAction(menu, "Analyse", actions.analyse);
  if (kind != DragTarget::Kind::cable) {
    addAction(menu, "Set as design", actions.set_as_design);
    addAction(menu, "Put back", actions.put_back);
    addAction(menu, "Reset", actions.reset);
  }
  const MenuHandler::EntryHandle add = menu.insert("Add a clip here");
  for (const cable_variation::ClipPresetTraits& preset : cable_variation::clipPresets()) {
    if (!canBeAdded(preset)) continue;
    const std::string type = preset.name;
    menu.insert(add, type, [add_clip = actions.add_clip, type](const Feedback& feedback) {
      add_clip(dragTargetOf(feedback->marker_name), pointOf(*feedback), type);
    });
  }
  if (kind == DragTarget::Kind::component) {
    menu.insert("Add a cable here", [add_cable = actions.add_cable](const Feedback& feedback) {
      add_cable(dragTargetOf(feedback->marker_name), pointOf(*feedback));
    });
  }
  return menu;
}

}  // namespace cable_variation_ros
