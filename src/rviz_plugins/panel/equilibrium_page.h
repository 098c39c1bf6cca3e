#pragma once

#include <rviz_plugins/panel/analysis_page.h>

#ifndef Q_MOC_RUN
#include <cable_variation/SolveEquilibrium.h>
#endif

class QComboBox;
class QLineEdit;

namespace cable_variation_rviz {

class CopyableTable;
class ResultModel;

/// The equilibrium of the design in force: the cables and what the clips have to hold.
class EquilibriumPage : public AnalysisPage {
  Q_OBJECT

 public:
  explicit EquilibriumPage(SolverConnection& solver, QWidget* parent = nullptr);
  void start() override;

 private:
  void show(const cable_variation::SolveEquilibriumResponse& answer);

  QComboBox* from_;
  QLineEdit* report_;
  ResultModel* cables_;
  ResultModel* reactions_;
};

}  // namespace cable_variation_rviz
