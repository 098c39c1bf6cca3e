#include <rviz_plugins/panel/stability_page.h>

#include <QCheckBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QTabWidget>
#include <QVBoxLayout>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/heat_map.h>
#include <rviz_plugins/panel/measure_table_model.h>
#include <rviz_plugins/panel/result_model.h>
#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

using cable_variation::AnalyzeStabilityResponse;
using cable_variation::displayUnit;

StabilityPage::StabilityPage(SolverConnection& solver, QWidget* parent)
    : AnalysisPage(solver, parent),
      low_high_(new QCheckBox("each variable at its limits too (low, high, snaps)")),
      report_(new QLineEdit),
      measures_(new ResultModel(this)),
      contributions_(new HeatMap) {
  low_high_->setChecked(true);
  report_->setObjectName("name");
  report_->setPlaceholderText("no files");
  report_->setToolTip("A name without a folder: NAME.html and NAME.csv go to the solver's output folder");
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(low_high_);
  form->addRow("Report", report_);
  optionsLayout()->addLayout(form);
  auto* table = new CopyableTable;
  table->show(measures_);
  auto* tabs = new QTabWidget;
  tabs->addTab(contributions_, "Contributions [%]");
  tabs->addTab(table, "Measures");
  resultsLayout()->addWidget(tabs);
  connect(contributions_, &HeatMap::variableChosen, this, &StabilityPage::variableChosen);
}

void StabilityPage::start() {
  cable_variation::AnalyzeStabilityRequest request;
  request.skip_low_high = !low_high_->isChecked();
  request.report = report_->text().trimmed().toStdString();
  Q_EMIT progressed(-1.0, "analysing", -1.0);
  solver_.ask<cable_variation::AnalyzeStability>(
      service("analyze_stability"), request, "",
      [this](const AnalyzeStabilityResponse& answer, const std::string& failure) {
        if (!answer.measures.empty()) show(answer);  // a file that was not written leaves the figures
        Q_EMIT ended(QString::fromStdString(failure));
      });
}

void StabilityPage::show(const AnalyzeStabilityResponse& answer) {
  std::vector<std::vector<ResultCell>> rows;
  for (std::size_t i = 0; i < answer.measures.size(); ++i) {
    const auto& measure = answer.measures[i];
    ResultCell name = textCell(measure.name, QString::fromStdString(answer.undefined[i]));
    if (measure.has_lower || measure.has_upper) name.verdict = measure.within ? Verdict::good : Verdict::bad;
    rows.push_back(
        {name, numberCell(measure.value, measure.unit), numberCell(answer.sigma[i], measure.unit),
         numberCell(measure.value + answer.worst_low[i], measure.unit),
         numberCell(measure.value + answer.worst_high[i], measure.unit),
         textCell(limitsText(measure.has_lower, measure.lower, measure.has_upper, measure.upper, measure.unit)
                      .toStdString()),
         textCell(displayUnit(measure.unit).symbol)});
  }
  measures_->setTable(
      {"Measure", "Nominal", QString::fromUtf8("\u03c3"), "Worst low", "Worst high", "Limits", "Unit"},
      std::move(rows));
  ContributionMatrix matrix;
  for (const auto& variable : answer.variables) matrix.variables.push_back(variable.name);
  for (const auto& measure : answer.measures) matrix.measures.push_back(measure.name);
  matrix.share = answer.contribution;
  matrix.derivative = answer.jacobian;
  contributions_->setMatrix(matrix);
  QStringList lines = {QString("Shown: the effect of %1. Coupling: %2; %3.")
                           .arg(QString::fromStdString(answer.shown), QString::fromStdString(answer.coupling),
                                eigenvalueText(answer.smallest_eigenvalue))};
  for (const auto& snap : answer.snaps) {
    lines << QString::fromStdString("snaps over as " + snap.variable + " varies, by " +
                                    cable_variation::displayValue(snap.jump, "m") + " of " + snap.cable);
  }
  setSummary(summaryLines(lines, answer.warnings, {answer.report_file, answer.csv_file}));
}

}  // namespace cable_variation_rviz
