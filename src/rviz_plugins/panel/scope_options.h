#pragma once

#include <string>
#include <vector>

#include <QWidget>

#ifndef Q_MOC_RUN
#include <cable_variation/GetScene.h>
#endif

class QComboBox;
class QFormLayout;
class QLineEdit;
class QListWidget;
class QToolButton;

namespace cable_variation_rviz {

/// What an envelope and a simulation both ask: which variables vary, at rest or over which motion, and the
/// name that files are written under.
class ScopeOptions : public QWidget {
  Q_OBJECT

 public:
  /// @param files what is written: "STL, URDF"
  explicit ScopeOptions(const QString& files, QWidget* parent = nullptr);

  void setScene(const cable_variation::GetSceneResponse& scene);

  std::vector<std::string> variables() const;  ///< those chosen
  std::vector<std::string> motions() const;    ///< none: at rest
  std::string name() const;                    ///< of files; empty: none

  /// For more rows.
  QFormLayout* form() const { return form_; }

 private:
  void setAll(Qt::CheckState state);
  void tellChosen();

  QFormLayout* form_;
  QToolButton* variables_button_;
  QListWidget* variables_;
  QComboBox* motion_;
  QLineEdit* name_;
};

}  // namespace cable_variation_rviz
