#include <rviz_plugins/panel/camera_start.h>

#include <cmath>

#include <Eigen/Geometry>
#include <OgreAxisAlignedBox.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <QTimer>
#include <rviz/display_context.h>
#include <rviz/properties/property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

namespace {

using Box = Eigen::AlignedBox3d;

constexpr int kPatience = 1500;                    // until displays have drawn the scene [ms]
constexpr double kFrame = 2.2;                     // distance of the camera, in diagonals of what it looks at
constexpr double kNearest = 0.5, kFarthest = 8.0;  // where it may stay, likewise
constexpr double kLargest = 1e4;                   // of a scene to be looked at [m]

Box boxOf(const cable_variation::CableShapes& shapes) {
  Box box;
  for (const auto& cable : shapes.cables) {
    for (const auto& point : cable.centreline) box.extend(Eigen::Vector3d(point.x, point.y, point.z));
  }
  return box;
}

Box boxOf(Ogre::SceneManager& scene) {
  Ogre::SceneNode* root = scene.getRootSceneNode();
  root->_update(true, false);
  const Ogre::AxisAlignedBox& all = root->_getWorldAABB();
  if (!all.isFinite()) return {};
  const Ogre::Vector3 low = all.getMinimum(), high = all.getMaximum();
  return Box(Eigen::Vector3d(low.x, low.y, low.z), Eigen::Vector3d(high.x, high.y, high.z));
}

}  // namespace

CameraStart::CameraStart(SolverConnection& solver, rviz::DisplayContext& context, QObject* parent)
    : QObject(parent), context_(context), due_(new QTimer(this)) {
  due_->setSingleShot(true);
  due_->setInterval(kPatience);
  connect(due_, &QTimer::timeout, this, &CameraStart::look);
  shapes_ = solver.hear<cable_variation::CableShapes>(
      solver.solver() + "/shapes",
      [this](const cable_variation::CableShapesConstPtr& shapes) { heard_ = shapes; });
}

void CameraStart::sceneChanged() {
  before_ = view();
  due_->start();
}

// Where the camera looks [m] and from how far [m]; none: it is not one that orbits.
std::optional<Eigen::Vector4d> CameraStart::view() const {
  rviz::ViewController* camera = context_.getViewManager()->getCurrent();
  rviz::Property* focus = camera != nullptr ? camera->subProp("Focal Point") : nullptr;
  rviz::Property* distance = camera != nullptr ? camera->subProp("Distance") : nullptr;
  if (focus == nullptr || distance == nullptr || focus->numChildren() < 3) return std::nullopt;
  Eigen::Vector4d view;
  for (int i = 0; i < 3; ++i) view[i] = focus->childAt(i)->getValue().toDouble();
  view[3] = distance->getValue().toDouble();
  return view;
}

void CameraStart::look() {
  const std::optional<Eigen::Vector4d> now = view();
  if (!now || now != before_) return;
  Box box;
  if (heard_) box = boxOf(*heard_);
  if (box.isEmpty()) box = boxOf(*context_.getSceneManager());
  if (box.isEmpty()) return;
  const double size = box.diagonal().norm();
  if (!(size > 0.0 && size < kLargest)) return;
  const double away = (*now)[3];
  if (box.exteriorDistance(now->head<3>().eval()) < 0.5 * size && away > kNearest * size &&
      away < kFarthest * size)
    return;
  const Eigen::Vector3d middle = box.center();
  rviz::ViewController& camera = *context_.getViewManager()->getCurrent();
  for (int i = 0; i < 3; ++i) camera.subProp("Focal Point")->childAt(i)->setValue(middle[i]);
  camera.subProp("Distance")->setValue(kFrame * size);
}

}  // namespace cable_variation_rviz
