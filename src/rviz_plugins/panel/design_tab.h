#pragma once

#include <string>

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/DesignState.h>
#include <cable_variation/GetScene.h>
#include <cable_variation/LiveMeasures.h>
#include <ros/subscriber.h>
#endif

class QLabel;
class QPushButton;
class QTimer;

namespace cable_variation_rviz {

class CopyableTable;
class MeasureTableModel;
class SolverConnection;
class VariableTable;
class VariableTableModel;

/// The design in force: its variables, to be changed, and what that does to the measures. While a slider is
/// held the design follows it as fast as the solver does.
class DesignTab : public QWidget {
  Q_OBJECT

 public:
  explicit DesignTab(SolverConnection& solver, QWidget* parent = nullptr);

  void setScene(const cable_variation::GetSceneResponse& scene);
  void setState(const cable_variation::DesignState& state);
  /// Has the scene show what a variable does to the cables.
  void showEffect(const QString& variable);

 Q_SIGNALS:
  void failed(const QString& of, const QString& message);
  void succeeded(const QString& of);  ///< what it failed of before no longer matters

 private:
  void edit(int row, double value);
  void reset();
  void showMeasures();
  void tell(const char* of, const std::string& failure);  ///< how a request ended; empty: well

  SolverConnection& solver_;
  VariableTableModel* variables_;
  MeasureTableModel* measures_;
  VariableTable* variable_table_;
  CopyableTable* measure_table_;
  QPushButton* reset_all_;
  QTimer* measures_due_;
  ros::Subscriber measures_heard_;
  cable_variation::LiveMeasuresConstPtr measured_;  ///< last ones heard
  cable_variation::DesignState state_;              ///< last one heard
  std::size_t edits_ = 0;                           ///< asked for
  std::size_t edits_done_ = 0;                      ///< the newest answered
};

}  // namespace cable_variation_rviz
