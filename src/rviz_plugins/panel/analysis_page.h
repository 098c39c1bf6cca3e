#pragma once

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/GetScene.h>
#endif

class QLabel;
class QVBoxLayout;

namespace cable_variation_rviz {

class SolverConnection;

/// One kind of analysis: its few options, and its results below them.
class AnalysisPage : public QWidget {
  Q_OBJECT

 public:
  explicit AnalysisPage(SolverConnection& solver, QWidget* parent = nullptr);

  /// Another scene: what there is to be chosen from.
  virtual void setScene(const cable_variation::GetSceneResponse& /*scene*/) {}
  /// Asks for the analysis; ended() comes in any case.
  virtual void start() = 0;
  virtual bool canCancel() const { return false; }
  virtual void cancel() {}

 Q_SIGNALS:
  /// @param share done, 0 to 1; negative: not known
  /// @param remaining [s]; negative: not known
  void progressed(double share, const QString& what, double remaining);
  /// @param failure empty: all went well
  void ended(const QString& failure);
  void variableChosen(const QString& name);  ///< in a result

 protected:
  std::string service(const char* name) const;
  /// What a result says in a few lines, as HTML; links are opened.
  void setSummary(const QString& html);
  /// Options are above the summary, tables below.
  QVBoxLayout* optionsLayout() const { return options_; }
  QVBoxLayout* resultsLayout() const { return results_; }

  SolverConnection& solver_;

 private:
  QVBoxLayout* options_;
  QLabel* summary_;
  QVBoxLayout* results_;
};

/// "smallest eigenvalue 275 N/m", or that it is not known (not a number).
QString eigenvalueText(double eigenvalue);

/// Lines of a summary: each escaped, one below the other; a mark before warnings.
QString summaryLines(const QStringList& lines, const std::vector<std::string>& warnings,
                     const std::vector<std::string>& files);

}  // namespace cable_variation_rviz
