#pragma once

#include <rviz_plugins/panel/analysis_page.h>

#ifndef Q_MOC_RUN
#include <cable_variation/SimulateVariationAction.h>
#include <rviz_plugins/panel/action_run.h>
#endif

class QComboBox;
class QSpinBox;
class QVBoxLayout;

namespace cable_variation_rviz {

class HeatMap;
class ResultModel;
class ScopeOptions;

/// Production simulated: statistics and histograms of every measure, and which variables they come from.
class VariationPage : public AnalysisPage {
  Q_OBJECT

 public:
  explicit VariationPage(SolverConnection& solver, QWidget* parent = nullptr);
  void setScene(const cable_variation::GetSceneResponse& scene) override;
  void start() override;
  bool canCancel() const override { return true; }
  void cancel() override { run_.cancel(); }

 private:
  void show(const cable_variation::SimulateVariationResult& result);

  ActionRun<cable_variation::SimulateVariationAction> run_;
  ScopeOptions* scope_;
  QSpinBox* samples_;
  QComboBox* sampler_;
  ResultModel* statistics_;
  QVBoxLayout* histograms_;
  HeatMap* contributions_;
};

}  // namespace cable_variation_rviz
