#include <rviz_plugins/panel/envelope_page.h>

#include <QComboBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/result_model.h>
#include <rviz_plugins/panel/scope_options.h>

namespace cable_variation_rviz {

using cable_variation::displayValue;
using cable_variation::GenerateEnvelopeResult;

EnvelopePage::EnvelopePage(SolverConnection& solver, QWidget* parent)
    : AnalysisPage(solver, parent),
      run_(solver, service("generate_envelope_action")),
      scope_(new ScopeOptions("the surface (STL), its pieces (URDF) and the region (OBJ)")),
      probability_(new QComboBox),
      clearances_(new ResultModel(this)) {
  probability_->setObjectName("probability");
  probability_->addItem("all that the tolerances allow", 0.0);
  for (const double share : {0.9973, 0.99, 0.95}) {
    probability_->addItem(QString("%1 % of production").arg(100.0 * share), share);
  }
  probability_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  scope_->form()->insertRow(1, "Holds", probability_);
  optionsLayout()->addWidget(scope_);
  auto* table = new CopyableTable;
  table->setObjectName("clearances");
  table->show(clearances_);
  resultsLayout()->addWidget(table);
}

void EnvelopePage::setScene(const cable_variation::GetSceneResponse& scene) { scope_->setScene(scene); }

void EnvelopePage::start() {
  cable_variation::GenerateEnvelopeGoal goal;
  goal.variables = scope_->variables();
  goal.motions = scope_->motions();
  goal.probability = probability_->currentData().toDouble();
  goal.name = scope_->name();
  goal.motion_only = goal.variables.empty();
  run_.start(
      goal,
      [this](const cable_variation::GenerateEnvelopeFeedback& feedback) {
        Q_EMIT progressed(feedback.share, QString::fromStdString(feedback.stage), feedback.remaining);
      },
      [this](const GenerateEnvelopeResult& result, const std::string& failure) {
        if (result.pieces > 0) show(result);
        Q_EMIT ended(QString::fromStdString(failure));
      });
}

void EnvelopePage::show(const GenerateEnvelopeResult& result) {
  std::vector<std::vector<ResultCell>> rows;
  for (const auto& each : result.clearances) {
    ResultCell distance = numberCell(each.distance, "m", 3);
    if (each.has_limit) distance.verdict = each.distance >= each.limit ? Verdict::good : Verdict::bad;
    if (!each.has_limit && each.distance < 0.0) distance.verdict = Verdict::bad;
    rows.push_back({textCell(each.cable),
                    textCell(each.component.empty() ? each.other_cable : each.component,
                             QString::fromStdString(each.note)),
                    distance, each.has_limit ? numberCell(each.limit, "m", 3) : textCell(""),
                    numberCell(each.nominal, "m", 3), numberCell(each.worst_sample, "m", 3),
                    numberCell(each.arc_length, "m", 3), numberCell(each.time, "s", 3)});
  }
  clearances_->setTable({"Cable", "to", headerWithUnit("Clearance", "m"), headerWithUnit("Limit", "m"),
                         headerWithUnit("Nominal", "m"), headerWithUnit("Worst solved", "m"),
                         headerWithUnit("at s", "m"), "at t [s]"},
                        std::move(rows));
  const auto& held = result.containment;
  QStringList lines = {
      QString("%1 of %2 fresh shapes stick out, at most %3 % of all (95 % confidence); inflated by %4")
          .arg(held.outside)
          .arg(held.shapes)
          .arg(100.0 * held.outside_bound, 0, 'g', 2)
          .arg(QString::fromStdString(displayValue(result.inflation, "m", 2))),
      QString("%1 pieces, %2 equilibria, %3 s")
          .arg(result.pieces)
          .arg(result.solves)
          .arg(result.solve_time, 0, 'g', 3)};
  if (result.failures > 0) lines << QString("%1 harnesses without an equilibrium").arg(result.failures);
  if (result.branches > 1)
    lines << QString("The cables snap over within the tolerances: %1 shapes").arg(result.branches);
  setSummary(summaryLines(lines, result.warnings,
                          {result.report_file, result.mesh_file, result.urdf_file, result.region_file}));
}

}  // namespace cable_variation_rviz
