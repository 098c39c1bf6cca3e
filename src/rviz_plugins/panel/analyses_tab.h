#pragma once

#include <vector>

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/GetScene.h>
#endif

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace cable_variation_rviz {

class AnalysisPage;
class SolverConnection;

/// The analyses: one is chosen and run at a time, with a progress bar, the time left and a way to cancel.
class AnalysesTab : public QWidget {
  Q_OBJECT

 public:
  explicit AnalysesTab(SolverConnection& solver, QWidget* parent = nullptr);
  void setScene(const cable_variation::GetSceneResponse& scene);

 Q_SIGNALS:
  void failed(const QString& of, const QString& message);
  void succeeded(const QString& of);
  void variableChosen(const QString& name);

 private:
  void add(const QString& name, AnalysisPage* page);
  void run();
  void cancel();
  void progress(double share, const QString& what, double remaining);
  void end(const QString& failure);
  AnalysisPage* page() const;

  QComboBox* choice_;
  QStackedWidget* stack_;
  QPushButton* run_;
  QPushButton* cancel_;
  QProgressBar* bar_;
  QLabel* left_;
  std::vector<AnalysisPage*> pages_;
};

}  // namespace cable_variation_rviz
