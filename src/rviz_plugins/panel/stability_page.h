#pragma once

#include <rviz_plugins/panel/analysis_page.h>

#ifndef Q_MOC_RUN
#include <cable_variation/AnalyzeStability.h>
#endif

class QCheckBox;
class QLineEdit;

namespace cable_variation_rviz {

class HeatMap;
class ResultModel;

/// The stability analysis: spread and worst case of every measure, and which variables drive it.
class StabilityPage : public AnalysisPage {
  Q_OBJECT

 public:
  explicit StabilityPage(SolverConnection& solver, QWidget* parent = nullptr);
  void start() override;

 private:
  void show(const cable_variation::AnalyzeStabilityResponse& answer);

  QCheckBox* low_high_;
  QLineEdit* report_;
  ResultModel* measures_;
  HeatMap* contributions_;
};

}  // namespace cable_variation_rviz
