#include <rviz_plugins/panel/analysis_page.h>

#include <cmath>

#include <QFileInfo>
#include <QLabel>
#include <QUrl>
#include <QVBoxLayout>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/solver_connection.h>

namespace cable_variation_rviz {

AnalysisPage::AnalysisPage(SolverConnection& solver, QWidget* parent)
    : QWidget(parent),
      solver_(solver),
      options_(new QVBoxLayout),
      summary_(new QLabel),
      results_(new QVBoxLayout) {
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::RichText);
  summary_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  summary_->setOpenExternalLinks(true);
  summary_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addLayout(options_);
  layout->addWidget(summary_);
  layout->addLayout(results_, 1);
}

std::string AnalysisPage::service(const char* name) const { return solver_.solver() + "/" + name; }

void AnalysisPage::setSummary(const QString& html) {
  summary_->setText(html);
  summary_->setVisible(!html.isEmpty());
}

QString eigenvalueText(double eigenvalue) {
  if (std::isnan(eigenvalue)) return "smallest eigenvalue not known where cables touch parts";
  return "smallest eigenvalue " + QString::fromStdString(cable_variation::displayValue(eigenvalue, "N/m"));
}

QString summaryLines(const QStringList& lines, const std::vector<std::string>& warnings,
                     const std::vector<std::string>& files) {
  constexpr std::size_t kMostWarnings = 4;
  QStringList html;
  for (const QString& line : lines) html << line.toHtmlEscaped();
  for (std::size_t i = 0; i < std::min(kMostWarnings, warnings.size()); ++i) {
    html << QString::fromUtf8("<span style='color:#8a4b00'>\u26a0 %1</span>")
                .arg(QString::fromStdString(warnings[i]).toHtmlEscaped());
  }
  if (warnings.size() > kMostWarnings) {
    html << QString("and %1 more warnings").arg(warnings.size() - kMostWarnings);
  }
  for (const std::string& file : files) {
    if (file.empty()) continue;
    const QString path = QFileInfo(QString::fromStdString(file)).absoluteFilePath();
    html << QString("<a href='%1'>%2</a>")
                .arg(QUrl::fromLocalFile(path).toString(QUrl::FullyEncoded), path.toHtmlEscaped());
  }
  return html.join("<br>");
}

}  // namespace cable_variation_rviz
