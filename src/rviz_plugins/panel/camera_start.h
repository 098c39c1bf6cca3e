#pragma once

#include <optional>

#include <Eigen/Core>
#include <QObject>

#ifndef Q_MOC_RUN
#include <cable_variation/CableShapes.h>
#include <ros/subscriber.h>
#endif

class QTimer;

namespace rviz {
class DisplayContext;
}

namespace cable_variation_rviz {

class SolverConnection;

/// Has RViz's camera look at the scene that was loaded: at its cables or, of a scene without any, at all that
/// is displayed. A camera that has them in view already, as of a configuration made for the scene, stays, and
/// so does one that a person has moved meanwhile.
class CameraStart : public QObject {
  Q_OBJECT

 public:
  CameraStart(SolverConnection& solver, rviz::DisplayContext& context, QObject* parent = nullptr);

  /// Another scene: looks at it as soon as it is displayed.
  void sceneChanged();

 private:
  void look();
  std::optional<Eigen::Vector4d> view() const;

  rviz::DisplayContext& context_;
  QTimer* due_;
  ros::Subscriber shapes_;
  cable_variation::CableShapesConstPtr heard_;
  std::optional<Eigen::Vector4d> before_;  // view() when the scene changed
};

}  // namespace cable_variation_rviz
