#pragma once

#include <memory>
#include <string>

#include <rviz/panel.h>

#ifndef Q_MOC_RUN
#include <cable_variation/DesignState.h>
#include <ros/subscriber.h>
#endif

class QLabel;
class QPushButton;
class QTabWidget;
class QVBoxLayout;

namespace cable_variation_rviz {

class AnalysesTab;
class CameraStart;
class DesignTab;
class MessageLine;
class MotionBar;
class SolverConnection;

/// A review done with the mouse: the scene, its design and measures, analyses, the motion. All of it by the
/// services, actions and topics of the nodes, on other threads than RViz's.
class ReviewPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit ReviewPanel(QWidget* parent = nullptr);
  ~ReviewPanel() override;

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override { return {430, 860}; }

 private:
  void disconnectAll();
  void connectTo(const std::string& solver, const std::string& player);
  void follow(const cable_variation::DesignStateConstPtr& state);
  void takeScene();
  void takePlace();
  void chooseScene();
  void chooseName();
  void saveScene(const QString& name, bool overwrite);

  std::string solver_name_ = "/cable_solver";
  std::string player_name_ = "/moving_geometry_node";
  QLabel* scene_;
  QPushButton* load_;
  QPushButton* save_;
  QTabWidget* tabs_;
  QVBoxLayout* motion_place_;
  MessageLine* message_;
  DesignTab* design_ = nullptr;
  AnalysesTab* analyses_ = nullptr;
  MotionBar* motion_ = nullptr;
  CameraStart* camera_ = nullptr;
  cable_variation::DesignStateConstPtr state_;
  ros::Subscriber states_;
  std::unique_ptr<SolverConnection> solver_;  ///< last: what it calls is still there when it goes
};

}  // namespace cable_variation_rviz
