#pragma once

#include <QStyledItemDelegate>

namespace cable_variation_rviz {

/// A name, and below it, smaller and fainter, what it is (the data of a role); a mark before it if another
/// role is true. So a narrow table has both.
class TwoLineDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// @param detail_role of the second line
  /// @param mark_role of the mark; rows that have it are marked with a dot
  TwoLineDelegate(int detail_role, int mark_role, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int detail_role_;
  int mark_role_;
};

}  // namespace cable_variation_rviz
