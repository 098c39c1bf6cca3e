#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>

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
#include <QImage>

#include <Eigen/Geometry>

#include "eventually.h"

namespace cable_variation_rviz {

/// What RViz has drawn, and the camera that it was drawn with: the view's own may have moved on.
class Picture {
 public:
  Picture(QImage image, const Ogre::Camera& camera)
      : image_(std::move(image)),
        projection_(camera.getProjectionMatrix() * camera.getViewMatrix()),
        eye_(camera.getDerivedPosition().x, camera.getDerivedPosition().y, camera.getDerivedPosition().z) {}

  const QImage& image() const { return image_; }

  /// Where the camera stood [m], in the fixed frame.
  const Eigen::Vector3d& eye() const { return eye_; }

  /// Of a pixel, each part 0 to 255; -1: it is not on the picture.
  Eigen::Vector3d colourOf(const Eigen::Vector2d& pixel) const {
    const QPoint at(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
    if (!image_.rect().contains(at)) return Eigen::Vector3d::Constant(-1.0);
    const QColor color = image_.pixelColor(at);
    return {static_cast<double>(color.red()), static_cast<double>(color.green()),
            static_cast<double>(color.blue())};
  }

  /// Where a point of the fixed frame [m] is to be seen.
  Eigen::Vector3d colourAt(const Eigen::Vector3d& point) const { return colourOf(pixelOf(point)); }

 private:
  Eigen::Vector2d pixelOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector3f at = point.cast<float>();
    const Ogre::Vector4 seen = projection_ * Ogre::Vector4(at.x(), at.y(), at.z(), 1.0F);
    return {0.5 * image_.width() * (1.0 + seen.x / seen.w), 0.5 * image_.height() * (1.0 - seen.y / seen.w)};
  }

  QImage image_;
  Ogre::Matrix4 projection_;
  Eigen::Vector3d eye_;
};

/// A real RViz with a configuration.
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
  Picture shot() const {
    const auto drawn = manager().getFrameCount();
    eventually([&] { return manager().getFrameCount() > drawn + 3; });
    const Ogre::Camera& camera = *manager().getViewManager()->getCurrent()->getCamera();
    Ogre::RenderWindow& window = *manager().getRenderPanel()->getRenderWindow();
    const auto width = static_cast<int>(window.getWidth()), height = static_cast<int>(window.getHeight());
    QImage image(width, height, QImage::Format_RGB32);
    const Ogre::PixelBox pixels(window.getWidth(), window.getHeight(), 1, Ogre::PF_A8R8G8B8, image.bits());
#if OGRE_VERSION < OGRE_VERSION_CHECK(1, 12, 0)
    window.copyContentsToMemory(pixels);
#else
    window.copyContentsToMemory(Ogre::Box(pixels), pixels);
#endif
    return Picture(image, camera);
  }

 private:
  rviz::VisualizationManager& manager() const { return *frame_->getManager(); }

  std::unique_ptr<rviz::VisualizationFrame> frame_;
};

}  // namespace cable_variation_rviz
