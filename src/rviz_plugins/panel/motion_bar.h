#pragma once

#include <string>

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/MotionState.h>
#include <ros/subscriber.h>
#endif

class QLabel;
class QSlider;
class QToolButton;

namespace cable_variation_rviz {

class SolverConnection;

/// The time of the motions that a moving_geometry_node plays: play and halt, and a slider to go to any time.
/// Hidden while there is no motion.
class MotionBar : public QWidget {
  Q_OBJECT

 public:
  /// @param player the node's name, such as /moving_geometry_node
  MotionBar(SolverConnection& connection, std::string player, QWidget* parent = nullptr);

 Q_SIGNALS:
  void failed(const QString& of, const QString& message);
  void succeeded(const QString& of);

 private:
  void show(const cable_variation::MotionState& state);
  void play(bool playing);
  void seek(double time);
  void tell(const char* of, const std::string& failure);  ///< how a request ended; empty: well
  void showTime(double time);

  SolverConnection& connection_;
  std::string player_;
  QToolButton* play_;
  QSlider* slider_;
  QLabel* time_;
  ros::Subscriber states_;
  cable_variation::MotionState state_;
};

}  // namespace cable_variation_rviz
