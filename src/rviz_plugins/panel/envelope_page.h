#pragma once

#include <rviz_plugins/panel/analysis_page.h>

#ifndef Q_MOC_RUN
#include <cable_variation/GenerateEnvelopeAction.h>
#include <rviz_plugins/panel/action_run.h>
#endif

class QComboBox;

namespace cable_variation_rviz {

class ResultModel;
class ScopeOptions;

/// The space that the cables take up within their tolerances, and its clearances.
class EnvelopePage : public AnalysisPage {
  Q_OBJECT

 public:
  explicit EnvelopePage(SolverConnection& solver, QWidget* parent = nullptr);
  void setScene(const cable_variation::GetSceneResponse& scene) override;
  void start() override;
  bool canCancel() const override { return true; }
  void cancel() override { run_.cancel(); }

 private:
  void show(const cable_variation::GenerateEnvelopeResult& result);

  ActionRun<cable_variation::GenerateEnvelopeAction> run_;
  ScopeOptions* scope_;
  QComboBox* probability_;
  ResultModel* clearances_;
};

}  // namespace cable_variation_rviz
