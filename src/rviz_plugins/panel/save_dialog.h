#pragma once

#include <QDialog>

class QCheckBox;
class QLineEdit;

namespace cable_variation_rviz {

/// Asks for the name of a scene file to be written.
class SaveDialog : public QDialog {
  Q_OBJECT

 public:
  explicit SaveDialog(const QString& proposed, QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const QString& name, bool overwrite);

 private:
  void accept() override;

  QLineEdit* name_;
  QCheckBox* overwrite_;
};

}  // namespace cable_variation_rviz
