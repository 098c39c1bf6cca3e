#include <ros_interface/interaction/drag_markers.h>

#include <array>
#include <stdexcept>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Pose;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;

namespace {

const Eigen::Vector4d kIdle(0.25, 0.55, 0.95, 0.45), kChanged(0.98, 0.60, 0.10, 0.60),
    kSheath(1.0, 1.0, 1.0, 0.04);
constexpr double kSheathThickness = 1.25;  // of the cable's own
constexpr std::array<const char*, 3> kKinds{"clip/", "component/", "cable/"};

const char* prefixOf(DragTarget::Kind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

// The control's x axis is what it turns about or moves along.
void addAxis(InteractiveMarker& marker, const char* axis, const Eigen::Quaterniond& orientation) {
  InteractiveMarkerControl control;
  control.orientation = toQuaternion(orientation);
  control.name = std::string("move_") + axis;
  control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
  marker.controls.push_back(control);
  control.name = std::string("rotate_") + axis;
  control.interaction_mode = InteractiveMarkerControl::ROTATE_AXIS;
  marker.controls.push_back(control);
}

InteractiveMarkerControl handle(std::vector<visualization_msgs::Marker> look, std::uint8_t mode) {
  InteractiveMarkerControl control;
  control.name = "handle";
  control.interaction_mode = mode;
  control.always_visible = true;
  control.markers = std::move(look);
  for (visualization_msgs::Marker& each : control.markers) each.header = std_msgs::Header();  // on the marker
  return control;
}

InteractiveMarker markerOf(const DragTarget& target, const Pose& pose, double size) {
  InteractiveMarker marker;
  marker.header.frame_id = kWorldFrame;
  marker.name = target.markerName();
  marker.pose = toPose(pose);
  marker.scale = static_cast<float>(size);
  return marker;
}

}  // namespace

std::string DragTarget::markerName() const { return prefixOf(kind) + name; }

DragTarget dragTargetOf(const std::string& marker_name) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const std::string prefix = kKinds[i];
    if (marker_name.compare(0, prefix.size(), prefix) == 0)
      return {static_cast<DragTarget::Kind>(i), marker_name.substr(prefix.size())};
  }
  throw std::invalid_argument("interactive marker '" + marker_name +
                              "'; expected clip/, component/ or cable/");
}

InteractiveMarker dragMarker(const DragTarget& target, const Pose& pose, double size, bool open,
                             bool changed) {
  constexpr double kHandle = 0.3;  // of the size of the whole
  InteractiveMarker marker = markerOf(target, pose, size);
  // a clip's name stands among the labels already
  if (open && target.kind != DragTarget::Kind::clip) marker.description = target.name;
  MarkerGroup look("", "", changed ? kChanged : kIdle);
  if (target.kind == DragTarget::Kind::clip) {
    look.addSphere(Eigen::Vector3d::Zero(), 0.5 * kHandle * size);
  } else {
    look.addBox(Pose(), Eigen::Vector3d::Constant(kHandle * size));
  }
  marker.controls.push_back(handle(look.markers(), InteractiveMarkerControl::BUTTON));
  if (!open) return marker;
  addAxis(marker, "x", Eigen::Quaterniond::Identity());
  addAxis(marker, "y",
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()));
  addAxis(marker, "z",
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()));
  return marker;
}

InteractiveMarker cableMarker(const cable_variation::CableShape& shape, const cable_variation::Cable& cable) {
  InteractiveMarker marker = markerOf({DragTarget::Kind::cable, cable.name}, Pose(), 1.0);
  MarkerGroup look("", "", kSheath);
  CableLook sheath;
  sheath.thickness = kSheathThickness;
  addCable(look, shape, cable, sheath);
  marker.controls.push_back(handle(look.markers(), InteractiveMarkerControl::MENU));
  return marker;
}

}  // namespace cable_variation_ros
