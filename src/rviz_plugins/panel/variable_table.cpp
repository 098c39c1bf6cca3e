#include <rviz_plugins/panel/variable_table.h>

#include <QHeaderView>
#include <QToolButton>

#include <rviz_plugins/panel/slider_delegate.h>
#include <rviz_plugins/panel/two_line_delegate.h>
#include <rviz_plugins/panel/variable_table_model.h>

namespace cable_variation_rviz {

using Model = VariableTableModel;

VariableTable::VariableTable(Model* variables, QWidget* parent) : QTableView(parent), variables_(variables) {
  setObjectName("variables");
  setModel(variables);
  setItemDelegateForColumn(Model::kName, new TwoLineDelegate(Model::kDescription, Model::kChanged, this));
  setItemDelegateForColumn(Model::kSlider, new SliderDelegate(this));
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setEditTriggers(DoubleClicked | SelectedClicked | EditKeyPressed);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setShowGrid(false);
  setAlternatingRowColors(true);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  QHeaderView* columns = horizontalHeader();
  columns->setMinimumSectionSize(24);
  columns->setSectionResizeMode(Model::kName, QHeaderView::Stretch);
  columns->setSectionResizeMode(Model::kSlider, QHeaderView::Stretch);
  columns->setSectionResizeMode(Model::kValue, QHeaderView::Fixed);
  columns->setSectionResizeMode(Model::kReset, QHeaderView::Fixed);
  columns->resizeSection(Model::kValue, fontMetrics().horizontalAdvance("-0.123456 mmm"));
  columns->resizeSection(Model::kReset, fontMetrics().height() + 12);
  columns->setHighlightSections(false);
  connect(variables, &Model::modelReset, this, &VariableTable::openSliders);
  connect(variables, &Model::dataChanged, this, &VariableTable::showResets);
  connect(this, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == Model::kName) Q_EMIT chosen(index.row());
  });
  openSliders();
}

void VariableTable::openSliders() {
  for (int row = 0; row < variables_->rowCount(); ++row) {
    openPersistentEditor(variables_->index(row, Model::kSlider));
    auto* button = new QToolButton;
    button->setObjectName("reset");
    button->setText(QString::fromUtf8("\u21ba"));
    button->setAutoRaise(true);
    button->setToolTip("As the scene has it: " +
                       variables_->index(row, Model::kName).data(Qt::DisplayRole).toString());
    connect(button, &QToolButton::clicked, this, [this, row] { Q_EMIT resetRequested(row); });
    setIndexWidget(variables_->index(row, Model::kReset), button);
  }
  showResets();
}

void VariableTable::showResets() {
  for (int row = 0; row < variables_->rowCount(); ++row) {
    if (QWidget* button = indexWidget(variables_->index(row, Model::kReset))) {
      button->setVisible(variables_->changed(row));
    }
  }
}

}  // namespace cable_variation_rviz
