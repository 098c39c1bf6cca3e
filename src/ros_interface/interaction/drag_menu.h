#pragma once

#include <functional>
#include <string>

#include <interactive_markers/menu_handler.h>

#include <ros_interface/interaction/drag_markers.h>

namespace cable_variation_ros {

/// What the menus of clips, components and cables do.
struct DragActions {
  using OnTarget = std::function<void(const DragTarget&)>;
  OnTarget analyse, set_as_design, put_back, reset;
  /// @param point in the world, that was clicked on
  std::function<void(const DragTarget&, const Eigen::Vector3d& point, const std::string& type)> add_clip;
  std::function<void(const DragTarget&, const Eigen::Vector3d& point)> add_cable;  ///< on a component
};

/// The menus that a right click opens, for things of one kind.
interactive_markers::MenuHandler dragMenu(DragTarget::Kind kind, const DragActions& actions);

}  // namespace cable_variation_ros
