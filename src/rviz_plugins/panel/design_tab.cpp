#include <rviz_plugins/panel/design_tab.h>

#include <algorithm>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include <cable_variation/AnalyzeStability.h>
#include <cable_variation/SetDesign.h>

#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/measure_table_model.h>
#include <rviz_plugins/panel/solver_connection.h>
#include <rviz_plugins/panel/variable_table.h>
#include <rviz_plugins/panel/variable_table_model.h>

namespace cable_variation_rviz {

namespace {

constexpr char kEdit[] = "edit";
constexpr int kMeasuresPause = 100;  // between two sets of them that are shown [ms]

}  // namespace

DesignTab::DesignTab(SolverConnection& solver, QWidget* parent)
    : QWidget(parent),
      solver_(solver),
      variables_(new VariableTableModel(this)),
      measures_(new MeasureTableModel(this)),
      variable_table_(new VariableTable(variables_)),
      measure_table_(new CopyableTable),
      reset_all_(new QPushButton("Reset all")),
      measures_due_(new QTimer(this)) {
  reset_all_->setObjectName("reset_all");
  reset_all_->setToolTip("The design as the scene file has it, clips and lengths too");
  reset_all_->setEnabled(false);
  measure_table_->setObjectName("measures");
  measure_table_->show(measures_);
  measure_table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  measure_table_->horizontalHeader()->setSectionResizeMode(MeasureTableModel::kName, QHeaderView::Stretch);
  measures_due_->setSingleShot(true);
  measures_due_->setInterval(kMeasuresPause);

  auto* upper = new QWidget;
  auto* upper_layout = new QVBoxLayout(upper);
  upper_layout->setContentsMargins(0, 0, 0, 0);
  upper_layout->addWidget(variable_table_, 1);
  auto* below = new QHBoxLayout;
  auto* hint = new QLabel("Click a name to see what it does to the cables.");
  hint->setWordWrap(true);
  below->addWidget(hint, 1);
  below->addWidget(reset_all_);
  upper_layout->addLayout(below);
  auto* splitter = new QSplitter(Qt::Vertical);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(upper);
  splitter->addWidget(measure_table_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(splitter);

  connect(variables_, &VariableTableModel::designEdited, this, &DesignTab::edit);
  connect(variables_, &VariableTableModel::refused, this,
          [this](const QString& message) { Q_EMIT failed(kEdit, message); });
  connect(variable_table_, &VariableTable::chosen, this,
          [this](int row) { showEffect(QString::fromStdString(variables_->variable(row).name)); });
  connect(variable_table_, &VariableTable::resetRequested, this, [this](int row) { variables_->reset(row); });
  connect(reset_all_, &QPushButton::clicked, this, &DesignTab::reset);
  connect(measures_due_, &QTimer::timeout, this, &DesignTab::showMeasures);
  measures_heard_ = solver_.hear<cable_variation::LiveMeasures>(
      solver_.solver() + "/measures", [this](const cable_variation::LiveMeasuresConstPtr& measured) {
        measured_ = measured;
        if (!measures_due_->isActive()) measures_due_->start();
      });
}

void DesignTab::setScene(const cable_variation::GetSceneResponse& scene) {
  variables_->setVariables(scene.design_variables);
}

void DesignTab::setState(const cable_variation::DesignState& state) {
  state_ = state;
  if (edits_ != edits_done_) return;  // older than what the person has just set
  variables_->setState(state);
  reset_all_->setEnabled(state.edited);
}

void DesignTab::edit(int row, double value) {
  cable_variation::SetDesignRequest request;
  request.variables = {variables_->variable(row).name};
  request.values = {value};
  const std::size_t number = ++edits_;
  reset_all_->setEnabled(true);
  // A slider is moved one at a time: an older value of the same variable is out of date, others are not.
  solver_.ask<cable_variation::SetDesign>(
      solver_.solver() + "/set_design", request, "set_design " + request.variables[0],
      [this, number](const cable_variation::SetDesignResponse& response, const std::string& failure) {
        edits_done_ = std::max(edits_done_, number);
        tell(kEdit, failure);
        if (!failure.empty()) {
          setState(cable_variation::DesignState(state_));  // back to what is in force
        } else if (!response.warnings.empty()) {
          tell(kEdit, response.warnings.front());
        }
      });
}

void DesignTab::reset() {
  const std::size_t number = ++edits_;
  solver_.ask<std_srvs::Trigger>(
      solver_.solver() + "/reset_design", {}, "",
      [this, number](const std_srvs::TriggerResponse&, const std::string& failure) {
        edits_done_ = std::max(edits_done_, number);
        setState(cable_variation::DesignState(state_));
        tell(kEdit, failure);
      });
}

void DesignTab::showEffect(const QString& variable) {
  cable_variation::AnalyzeStabilityRequest request;
  request.variables = {variable.toStdString()};
  request.show = request.variables[0];
  request.skip_low_high = true;
  solver_.ask<cable_variation::AnalyzeStability>(
      solver_.solver() + "/analyze_stability", request, "show effect",
      [this](const cable_variation::AnalyzeStabilityResponse&, const std::string& failure) {
        tell("effect", failure);
      });
}

void DesignTab::showMeasures() {
  if (measured_->status.code == cable_variation::Status::SUCCESS) {
    measures_->setMeasures(measured_->measures);
  } else {
    measures_->setOutdated(true);
  }
}

void DesignTab::tell(const char* of, const std::string& failure) {
  if (failure.empty()) {
    Q_EMIT succeeded(of);
  } else {
    Q_EMIT failed(of, QString::fromStdString(failure));
  }
}

}  // namespace cable_variation_rviz
