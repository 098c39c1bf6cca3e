#include <rviz_plugins/panel/equilibrium_page.h>

#include <cmath>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QTabWidget>
#include <QVBoxLayout>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/result_model.h>
#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

using cable_variation::displayValue;
using cable_variation::SolveEquilibriumResponse;

namespace {

double normOf(const geometry_msgs::Vector3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

std::vector<ResultCell> reactionRow(const std::string& what, const geometry_msgs::Vector3& force,
                                    const geometry_msgs::Vector3& moment) {
  return {textCell(what),           numberCell(normOf(force), "N"), numberCell(normOf(moment), "N m"),
          numberCell(force.x, "N"), numberCell(force.y, "N"),       numberCell(force.z, "N")};
}

}  // namespace

EquilibriumPage::EquilibriumPage(SolverConnection& solver, QWidget* parent)
    : AnalysisPage(solver, parent),
      from_(new QComboBox),
      report_(new QLineEdit),
      cables_(new ResultModel(this)),
      reactions_(new ResultModel(this)) {
  from_->addItem("from nothing: the shape of lowest energy");
  from_->addItem("from the shape shown");
  from_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow("Search", from_);
  report_->setObjectName("name");
  report_->setPlaceholderText("no file");
  report_->setToolTip("A name without a folder: NAME.html goes to the solver's output folder");
  form->addRow("Report", report_);
  optionsLayout()->addLayout(form);
  auto* tabs = new QTabWidget;
  for (const auto& [name, model] :
       {std::make_pair("Cables", cables_), std::make_pair("Reactions", reactions_)}) {
    auto* table = new CopyableTable;
    table->show(model);
    tabs->addTab(table, name);
  }
  resultsLayout()->addWidget(tabs);
}

void EquilibriumPage::start() {
  cable_variation::SolveEquilibriumRequest request;
  request.follow = from_->currentIndex() == 1;
  request.report = report_->text().trimmed().toStdString();
  Q_EMIT progressed(-1.0, "solving", -1.0);
  solver_.ask<cable_variation::SolveEquilibrium>(
      service("solve_equilibrium"), request, "",
      [this](const SolveEquilibriumResponse& answer, const std::string& failure) {
        if (!answer.shapes.empty()) show(answer);  // a file that was not written leaves the figures
        Q_EMIT ended(QString::fromStdString(failure));
      });
}

void EquilibriumPage::show(const SolveEquilibriumResponse& answer) {
  std::vector<std::vector<ResultCell>> cables, reactions;
  for (const auto& shape : answer.shapes) {
    cables.push_back({textCell(shape.cable), numberCell(shape.length, "m"),
                      numberCell(shape.smallest_bend_radius, "m"),
                      numberCell(shape.smallest_bend_radius_at, "m")});
  }
  cables_->setTable({"Cable", headerWithUnit("Length", "m"), headerWithUnit("Smallest bend radius", "m"),
                     headerWithUnit("at", "m")},
                    std::move(cables));
  for (const auto& each : answer.clip_reactions) {
    reactions.push_back(reactionRow(each.clip, each.force, each.moment));
  }
  for (const auto& each : answer.joint_reactions) {
    reactions.push_back(reactionRow(each.joint, each.force, each.moment));
  }
  for (const auto& each : answer.contacts) {
    std::vector<ResultCell> row = reactionRow(each.component + " on " + each.cable, each.force, {});
    row[2] = textCell("-");  // of a stretch it would be about some point
    reactions.push_back(std::move(row));
  }
  reactions_->setTable({"Clip, joint or part", "Force [N]", "Moment [N m]", "Fx [N]", "Fy [N]", "Fz [N]"},
                       std::move(reactions));
  const QStringList lines = {
      QString("Stable: %1; energy %2")
          .arg(eigenvalueText(answer.smallest_eigenvalue),
               QString::fromStdString(displayValue(answer.energy.total, "J"))),
      QString("Estimated error %1, residual %2; other stable shapes met: %3; solved in %4 ms")
          .arg(QString::fromStdString(displayValue(answer.discretisation_error, "m", 2)),
               QString::fromStdString(displayValue(answer.residual, "N", 2)))
          .arg(answer.alternatives.size())
          .arg(1e3 * answer.solve_time, 0, 'g', 3)};
  setSummary(summaryLines(lines, answer.warnings, {answer.report_file}));
}

}  // namespace cable_variation_rviz
