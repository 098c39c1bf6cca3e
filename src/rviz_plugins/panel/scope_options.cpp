#include <rviz_plugins/panel/scope_options.h>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include <rviz_plugins/panel/variable_table_model.h>

namespace cable_variation_rviz {

namespace {

constexpr int kName = Qt::UserRole;

}  // namespace

ScopeOptions::ScopeOptions(const QString& files, QWidget* parent)
    : QWidget(parent),
      form_(new QFormLayout(this)),
      variables_button_(new QToolButton),
      variables_(new QListWidget),
      motion_(new QComboBox),
      name_(new QLineEdit) {
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  variables_button_->setObjectName("variables_button");
  variables_button_->setPopupMode(QToolButton::InstantPopup);
  variables_button_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* chooser = new QWidget;
  auto* chooser_layout = new QVBoxLayout(chooser);
  auto* buttons = new QHBoxLayout;
  for (const auto& [text, state] :
       {std::make_pair("All", Qt::Checked), std::make_pair("None", Qt::Unchecked)}) {
    auto* button = new QPushButton(text);
    connect(button, &QPushButton::clicked, this, [this, state = state] { setAll(state); });
    buttons->addWidget(button);
  }
  chooser_layout->addLayout(buttons);
  chooser_layout->addWidget(variables_);
  variables_->setMinimumSize(300, 220);
  auto* popup = new QMenu(variables_button_);
  auto* action = new QWidgetAction(popup);
  action->setDefaultWidget(chooser);
  popup->addAction(action);
  variables_button_->setMenu(popup);
  motion_->setObjectName("motion");
  motion_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  name_->setObjectName("name");
  name_->setPlaceholderText("no files");
  name_->setToolTip("A name without a folder: " + files + " go to the solver's output folder");
  form_->addRow("Variables", variables_button_);
  form_->addRow("Motion", motion_);
  form_->addRow("Files", name_);
  connect(variables_, &QListWidget::itemChanged, this, &ScopeOptions::tellChosen);
}

void ScopeOptions::setScene(const cable_variation::GetSceneResponse& scene) {
  variables_->clear();
  for (const auto& variable : scene.design_variables) {
    const QString name = QString::fromStdString(variable.name);
    auto* item = new QListWidgetItem(name + ": " + descriptionOf(variable), variables_);
    item->setData(kName, name);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  tellChosen();
  motion_->clear();
  motion_->addItem("at rest");
  for (const auto& motion : scene.motions) motion_->addItem(QString::fromStdString(motion.name));
  form_->labelForField(motion_)->setVisible(!scene.motions.empty());
  motion_->setVisible(!scene.motions.empty());
}

std::vector<std::string> ScopeOptions::variables() const {
  std::vector<std::string> chosen;
  for (int i = 0; i < variables_->count(); ++i) {
    const QListWidgetItem* item = variables_->item(i);
    if (item->checkState() == Qt::Checked) chosen.push_back(item->data(kName).toString().toStdString());
  }
  return chosen;
}

std::vector<std::string> ScopeOptions::motions() const {
  if (motion_->currentIndex() <= 0) return {};
  return {motion_->currentText().toStdString()};
}

std::string ScopeOptions::name() const { return name_->text().trimmed().toStdString(); }

void ScopeOptions::setAll(Qt::CheckState state) {
  for (int i = 0; i < variables_->count(); ++i) variables_->item(i)->setCheckState(state);
}

void ScopeOptions::tellChosen() {
  const int all = variables_->count();
  const int chosen = static_cast<int>(variables().size());
  variables_button_->setText(chosen == all ? QString("all %1").arg(all)
                                           : QString("%1 of %2").arg(chosen).arg(all));
}

}  // namespace cable_variation_rviz
