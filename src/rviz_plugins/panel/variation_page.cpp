#include <rviz_plugins/panel/variation_page.h>

#include <cmath>

#include <QComboBox>
#include <QFormLayout>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/heat_map.h>
#include <rviz_plugins/panel/histogram_plot.h>
#include <rviz_plugins/panel/measure_table_model.h>
#include <rviz_plugins/panel/result_model.h>
#include <rviz_plugins/panel/scope_options.h>

namespace cable_variation_rviz {

using cable_variation::MeasureStatisticsResult;
using cable_variation::SimulateVariationResult;

namespace {

constexpr int kMostSamples = 10'000'000;

/// Capability, and the share beyond the limits as the samples have it.
std::vector<ResultCell> capabilityCells(const MeasureStatisticsResult& measure) {
  if (!measure.has_capability) return {textCell(""), textCell("")};
  ResultCell cpk;
  cpk.text = std::isfinite(measure.capability.cpk) ? QString::number(measure.capability.cpk, 'f', 2) : "-";
  cpk.sorted_by = measure.capability.cpk;
  cpk.number = true;
  return {cpk, numberCell(measure.capability.ppm_outside, "", 3)};
}

std::vector<ResultCell> statisticsRow(const MeasureStatisticsResult& measure) {
  const std::string& unit = measure.unit;
  std::vector<ResultCell> row = {textCell(measure.name), numberCell(measure.best_mean, unit),
                                 numberCell(measure.best_sigma, unit)};
  for (ResultCell& cell : capabilityCells(measure)) row.push_back(std::move(cell));
  row.push_back(numberCell(measure.min, unit));
  row.push_back(numberCell(measure.max, unit));
  row.push_back(textCell(
      limitsText(measure.has_lower, measure.lower, measure.has_upper, measure.upper, unit).toStdString()));
  row.push_back(textCell(cable_variation::displayUnit(unit).symbol));
  return row;
}

}  // namespace

VariationPage::VariationPage(SolverConnection& solver, QWidget* parent)
    : AnalysisPage(solver, parent),
      run_(solver, service("simulate_variation_action")),
      scope_(new ScopeOptions("the report (HTML), samples and statistics (CSV)")),
      samples_(new QSpinBox),
      sampler_(new QComboBox),
      statistics_(new ResultModel(this)),
      histograms_(new QVBoxLayout),
      contributions_(new HeatMap) {
  samples_->setObjectName("samples");
  samples_->setRange(2, kMostSamples);
  samples_->setValue(10000);
  samples_->setSingleStep(1000);
  samples_->setGroupSeparatorShown(true);
  sampler_->addItem("Monte Carlo", "monte_carlo");
  sampler_->addItem("Latin hypercube", "latin_hypercube");
  sampler_->addItem("Sobol'", "sobol");
  scope_->form()->insertRow(0, "Harnesses", samples_);
  scope_->form()->insertRow(1, "Sampler", sampler_);
  optionsLayout()->addWidget(scope_);

  auto* table = new CopyableTable;
  table->setObjectName("statistics");
  table->show(statistics_);
  auto* plots = new QWidget;
  auto* plots_layout = new QVBoxLayout(plots);
  plots_layout->setContentsMargins(0, 0, 0, 0);
  plots_layout->addLayout(histograms_);
  plots_layout->addStretch(1);
  auto* scrolled = new QScrollArea;
  scrolled->setWidgetResizable(true);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setWidget(plots);
  auto* tabs = new QTabWidget;
  tabs->addTab(table, "Statistics");
  tabs->addTab(scrolled, "Histograms");
  tabs->addTab(contributions_, "Contributions [%]");
  resultsLayout()->addWidget(tabs);
  connect(contributions_, &HeatMap::variableChosen, this, &VariationPage::variableChosen);
}

void VariationPage::setScene(const cable_variation::GetSceneResponse& scene) { scope_->setScene(scene); }

void VariationPage::start() {
  cable_variation::SimulateVariationGoal goal;
  goal.samples = static_cast<std::uint64_t>(samples_->value());
  goal.sampler = sampler_->currentData().toString().toStdString();
  goal.variables = scope_->variables();
  goal.motions = scope_->motions();
  goal.name = scope_->name();
  run_.start(
      goal,
      [this](const cable_variation::SimulateVariationFeedback& feedback) {
        const double wanted = static_cast<double>(feedback.wanted);
        Q_EMIT progressed(wanted > 0.0 ? static_cast<double>(feedback.samples) / wanted : -1.0,
                          QString("%1 of %2").arg(feedback.samples).arg(feedback.wanted), feedback.remaining);
      },
      [this](const SimulateVariationResult& result, const std::string& failure) {
        if (result.samples > 0) show(result);  // those done before it was cancelled count
        Q_EMIT ended(QString::fromStdString(failure));
      });
}

void VariationPage::show(const SimulateVariationResult& result) {
  std::vector<std::vector<ResultCell>> rows;
  while (QLayoutItem* old = histograms_->takeAt(0)) {
    delete old->widget();
    delete old;
  }
  for (const MeasureStatisticsResult& measure : result.measures) {
    rows.push_back(statisticsRow(measure));
    histograms_->addWidget(new HistogramPlot(measure));
  }
  statistics_->setTable({"Measure", "Mean", QString::fromUtf8("\u03c3"), "Cpk", "Outside [ppm]", "Min", "Max",
                         "Limits", "Unit"},
                        std::move(rows));
  ContributionMatrix matrix;
  for (const auto& variable : result.variables) matrix.variables.push_back(variable.name);
  for (const auto& measure : result.measures) matrix.measures.push_back(measure.name);
  matrix.share = result.first_order.empty() ? result.linear_contribution : result.first_order;
  contributions_->setMatrix(matrix);
  QStringList lines = {QString("%1 of %2 harnesses: %3 solved, %4 snapped over, %5 without an equilibrium")
                           .arg(result.samples)
                           .arg(result.wanted)
                           .arg(result.solved)
                           .arg(result.snapped)
                           .arg(result.not_converged + result.impossible),
                       QString("%1 a second").arg(result.samples_per_second, 0, 'f', 0)};
  setSummary(summaryLines(
      lines, result.warnings,
      {result.report_file, result.statistics_file, result.contributions_file, result.samples_file}));
}

}  // namespace cable_variation_rviz
