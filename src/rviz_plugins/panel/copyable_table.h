#pragma once

#include <QTableView>

class QHeaderView;
class QSortFilterProxyModel;

namespace cable_variation_rviz {

/// The data of a model's role that a table is sorted by: a number, or a text.
constexpr int kSortRole = Qt::UserRole + 100;

/// The cells that are selected, or all if none is, with the header of their columns: tab-separated, one row a
/// line. Text is as displayed, line breaks and tabs in it as blanks.
QString tabSeparated(const QTableView& table);

/// A table to be read: sorted by a click on a header, back in the model's order by a third one; copied with
/// Ctrl-C as tabSeparated().
class CopyableTable : public QTableView {
  Q_OBJECT

 public:
  explicit CopyableTable(QWidget* parent = nullptr);

  /// Rows of `model` are sorted by kSortRole.
  void show(QAbstractItemModel* model);
  /// Row of the model shown, of an index of this table.
  int sourceRow(const QModelIndex& index) const;

 protected:
  /// Has clicks on a header sort; the view's own one does.
  void sortOn(QHeaderView* header);
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void copy() const;
  void sortBy(int column);

  QSortFilterProxyModel* sorted_;
  int sorted_by_ = -1;
  Qt::SortOrder order_ = Qt::AscendingOrder;
};

}  // namespace cable_variation_rviz
