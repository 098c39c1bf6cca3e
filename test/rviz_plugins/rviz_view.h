#pragma once

#include <functional>
#include <memory>
#include <string>

#include <OgreCamera.h>
#include <OgreRenderWindow.h>
#include <rviz/display_group.h>
#include <rviz/ogre_helpers/version_check.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QtTest/QTest>

#include <Eigen/Geometry>

namespace cable_variation_rviz {

/// Lets Qt go on until `question` is true.
inline bool eventually(const std::function<bool()>& question, int patience = 60000) {  // [ms]
  QElapsedTimer time;
  time.start();
  while (!question()) {
    if (time.elapsed() > patience) return false;
    QTest::qWait(20);
  }
  return true;
}

/// A real RViz with a configuration, what it has drawn and where.
class RvizView {
 public:
  explicit RvizView(const std::string& config) : frame_(std::make_unique<rviz::VisualizationFrame>()) {
    frame_->setApp(qApp);
    frame_->setSplashPath("");
    frame_->initialize(QString::fromStdString(config));
    frame_->resize(1280, 800);
    frame_->show();
  }

  /// The first display of a class; nullptr: there is none.
  rviz::Display* display(const char* class_name) const {
    rviz::DisplayGroup& all = *manager().getRootDisplayGroup();
    for (int i = 0; i < all.numDisplays(); ++i) {
      if (all.getDisplayAt(i)->getClassId() == class_name) return all.getDisplayAt(i);
    }
    return nullptr;
  }

  /// All other displays are off.
  void showOnly(const rviz::Display* shown) const {
    rviz::DisplayGroup& all = *manager().getRootDisplayGroup();
    for (int i = 0; i < all.numDisplays(); ++i) all.getDisplayAt(i)->setEnabled(all.getDisplayAt(i) == shown);
  }

  /// Looks at a point [m], from a distance [m].
  void look(const Eigen::Vector3d& focus, double distance, double pitch, double yaw) const {
    rviz::Property& view = *manager().getViewManager()->getCurrent();
    for (int k = 0; k < 3; ++k) view.subProp("Focal Point")->childAt(k)->setValue(focus[k]);
    view.subProp("Distance")->setValue(distance);
    view.subProp("Pitch")->setValue(pitch);
    view.subProp("Yaw")->setValue(yaw);
  }

  /// What is drawn now, without the window around it.
  QImage shot() const {
    const auto drawn = manager().getFrameCount();
    eventually([&] { return manager().getFrameCount() > drawn + 3; });
    Ogre::RenderWindow& window = *manager().getRenderPanel()->getRenderWindow();
    const auto width = static_cast<int>(window.getWidth()), height = static_cast<int>(window.getHeight());
    QImage image(width, height, QImage::Format_RGB32);
    const Ogre::PixelBox pixels(window.getWidth(), window.getHeight(), 1, Ogre::PF_A8R8G8B8, image.bits());
#if OGRE_VERSION < OGRE_VERSION_CHECK(1, 12, 0)
    window.copyContentsToMemory(pixels);
#else
    window.copyContentsToMemory(Ogre::Box(pixels), pixels);
#endif
    return image;
  }

  /// Where a point of the fixed frame is on such a picture [px].
  Eigen::Vector2d pixelOf(const Eigen::Vector3d& point) const {
    const Ogre::Camera& camera = *manager().getViewManager()->getCurrent()->getCamera();
    const Eigen::Vector3f at = point.cast<float>();
    const Ogre::Vector4 seen =
        camera.getProjectionMatrix() * camera.getViewMatrix() * Ogre::Vector4(at.x(), at.y(), at.z(), 1.0F);
    const Ogre::RenderWindow& window = *manager().getRenderPanel()->getRenderWindow();
    return {0.5 * window.getWidth() * (1.0 + seen.x / seen.w),
            0.5 * window.getHeight() * (1.0 - seen.y / seen.w)};
  }

  Eigen::Vector3d eye() const {
    const Ogre::Vector3 at = manager().getViewManager()->getCurrent()->getCamera()->getDerivedPosition();
    return {at.x, at.y, at.z};
  }

 private:
  rviz::VisualizationManager& manager() const { return *frame_->getManager(); }

  std::unique_ptr<rviz::VisualizationFrame> frame_;
};

}  // namespace cable_variation_rviz
