#include <rviz_plugins/panel/save_dialog.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace cable_variation_rviz {

SaveDialog::SaveDialog(const QString& proposed, QWidget* parent)
    : QDialog(parent), name_(new QLineEdit(proposed)), overwrite_(new QCheckBox("Replace an older file")) {
  setObjectName("save_dialog");
  setWindowTitle("Save the design as a scene");
  setAttribute(Qt::WA_DeleteOnClose);
  name_->setObjectName("save_name");
  name_->setMinimumWidth(24 * fontMetrics().averageCharWidth());
  name_->selectAll();
  overwrite_->setObjectName("save_overwrite");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &SaveDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->addRow("Name", name_);
  form->addRow("", new QLabel("NAME.yaml, in the solver's output folder"));
  form->addRow("", overwrite_);
  form->addRow(buttons);
}

void SaveDialog::accept() {
  Q_EMIT chosen(name_->text().trimmed(), overwrite_->isChecked());
  QDialog::accept();
}

}  // namespace cable_variation_rviz
