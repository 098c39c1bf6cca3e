#pragma once

#include <QStyledItemDelegate>

namespace cable_variation_rviz {

/// Shows the place of a value within its tolerance (VariableTableModel::kShare) as a slider that is always
/// there: a view opens it as a persistent editor. Every movement sets the model's data; the mouse wheel
/// scrolls the table instead.
class SliderDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;
  bool eventFilter(QObject* editor, QEvent* event) override;
};

}  // namespace cable_variation_rviz
