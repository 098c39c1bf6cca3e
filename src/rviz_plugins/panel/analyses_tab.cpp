#include <rviz_plugins/panel/analyses_tab.h>

#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <rviz_plugins/panel/envelope_page.h>
#include <rviz_plugins/panel/equilibrium_page.h>
#include <rviz_plugins/panel/stability_page.h>
#include <rviz_plugins/panel/variation_page.h>

namespace cable_variation_rviz {

namespace {

/// "12 s", "3 min 5 s"
QString durationText(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 60 ? QString("%1 s").arg(whole) : QString("%1 min %2 s").arg(whole / 60).arg(whole % 60);
}

}  // namespace

AnalysesTab::AnalysesTab(SolverConnection& solver, QWidget* parent)
    : QWidget(parent),
      choice_(new QComboBox),
      stack_(new QStackedWidget),
      run_(new QPushButton("Run")),
      cancel_(new QPushButton("Cancel")),
      bar_(new QProgressBar),
      left_(new QLabel) {
  choice_->setObjectName("analysis");
  run_->setObjectName("run");
  cancel_->setObjectName("cancel");
  bar_->setObjectName("progress");
  cancel_->setEnabled(false);
  auto* top = new QHBoxLayout;
  top->addWidget(choice_, 1);
  top->addWidget(run_);
  top->addWidget(cancel_);
  auto* below = new QHBoxLayout;
  below->addWidget(bar_, 1);
  below->addWidget(left_);
  bar_->setRange(0, 1000);
  bar_->setMaximumHeight(fontMetrics().height() + 6);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(top);
  layout->addLayout(below);
  layout->addWidget(stack_, 1);
  bar_->hide();
  left_->hide();
  add("Equilibrium", new EquilibriumPage(solver));
  add("Stability", new StabilityPage(solver));
  add("Envelope", new EnvelopePage(solver));
  add("Variation", new VariationPage(solver));
  connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), stack_,
          &QStackedWidget::setCurrentIndex);
  connect(run_, &QPushButton::clicked, this, &AnalysesTab::run);
  connect(cancel_, &QPushButton::clicked, this, &AnalysesTab::cancel);
}

void AnalysesTab::add(const QString& name, AnalysisPage* page) {
  choice_->addItem(name);
  stack_->addWidget(page);
  pages_.push_back(page);
  connect(page, &AnalysisPage::progressed, this, &AnalysesTab::progress);
  connect(page, &AnalysisPage::ended, this, &AnalysesTab::end);
  connect(page, &AnalysisPage::variableChosen, this, &AnalysesTab::variableChosen);
}

AnalysisPage* AnalysesTab::page() const { return pages_[static_cast<std::size_t>(choice_->currentIndex())]; }

void AnalysesTab::setScene(const cable_variation::GetSceneResponse& scene) {
  for (AnalysisPage* each : pages_) each->setScene(scene);
}

void AnalysesTab::run() {
  choice_->setEnabled(false);
  run_->setEnabled(false);
  cancel_->setEnabled(page()->canCancel());
  Q_EMIT succeeded(choice_->currentText());
  progress(-1.0, "started", -1.0);
  page()->start();
}

void AnalysesTab::cancel() {
  cancel_->setEnabled(false);
  page()->cancel();
}

void AnalysesTab::progress(double share, const QString& what, double remaining) {
  bar_->show();
  left_->show();
  bar_->setRange(0, share < 0.0 ? 0 : 1000);  // without a range it only shows that something goes on
  if (share >= 0.0) bar_->setValue(static_cast<int>(std::lround(1000.0 * share)));
  bar_->setFormat(what + (share >= 0.0 ? ", %p %" : ""));
  left_->setText(remaining >= 0.0 ? durationText(remaining) + " left" : "");
}

void AnalysesTab::end(const QString& failure) {
  choice_->setEnabled(true);
  run_->setEnabled(true);
  cancel_->setEnabled(false);
  bar_->hide();
  left_->hide();
  if (failure.isEmpty()) {
    Q_EMIT succeeded(choice_->currentText());
  } else {
    Q_EMIT failed(choice_->currentText(), choice_->currentText() + ": " + failure);
  }
}

}  // namespace cable_variation_rviz
