#include <rviz_plugins/panel/copyable_table.h>

#include <set>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QStringList>

namespace cable_variation_rviz {

namespace {

QString inOneCell(QString text) { return text.replace('\t', ' ').replace('\n', ' '); }

}  // namespace

QString tabSeparated(const QTableView& table) {
  const QAbstractItemModel* model = table.model();
  if (model == nullptr) return {};
  std::set<int> rows, columns;
  for (const QModelIndex& index : table.selectionModel()->selectedIndexes()) {
    rows.insert(index.row());
    columns.insert(index.column());
  }
  if (rows.empty()) {
    for (int row = 0; row < model->rowCount(); ++row) rows.insert(row);
    for (int column = 0; column < model->columnCount(); ++column) columns.insert(column);
  }
  QStringList lines, cells;
  const bool named = model->headerData(0, Qt::Vertical).userType() == QMetaType::QString;
  if (named) cells << "";
  for (const int column : columns) cells << inOneCell(model->headerData(column, Qt::Horizontal).toString());
  lines << cells.join('\t');
  for (const int row : rows) {
    cells.clear();
    if (named) cells << inOneCell(model->headerData(row, Qt::Vertical).toString());
    for (const int column : columns) cells << inOneCell(model->index(row, column).data().toString());
    lines << cells.join('\t');
  }
  return lines.join('\n') + '\n';
}

CopyableTable::CopyableTable(QWidget* parent) : QTableView(parent), sorted_(new QSortFilterProxyModel(this)) {
  sorted_->setSortRole(kSortRole);
  setEditTriggers(NoEditTriggers);
  setAlternatingRowColors(true);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollMode(ScrollPerPixel);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionsClickable(true);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  sortOn(horizontalHeader());
}

void CopyableTable::sortOn(QHeaderView* header) {
  connect(header, &QHeaderView::sectionClicked, this, &CopyableTable::sortBy);
}

void CopyableTable::show(QAbstractItemModel* model) {
  sorted_->setSourceModel(model);
  setModel(sorted_);
}

int CopyableTable::sourceRow(const QModelIndex& index) const { return sorted_->mapToSource(index).row(); }

void CopyableTable::sortBy(int column) {
  if (column != sorted_by_) {
    order_ = Qt::AscendingOrder;
  } else if (order_ == Qt::AscendingOrder) {
    order_ = Qt::DescendingOrder;
  } else {
    column = -1;
  }
  sorted_by_ = column;
  sorted_->sort(column, order_);
  horizontalHeader()->setSortIndicatorShown(column >= 0);
  if (column >= 0) horizontalHeader()->setSortIndicator(column, order_);
}

void CopyableTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
  } else {
    QTableView::keyPressEvent(event);
  }
}

void CopyableTable::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction("Copy (Ctrl-C)", this, [this] { copy(); });
  menu.addAction("Select all", this, [this] { selectAll(); });
  menu.exec(event->globalPos());
}

void CopyableTable::copy() const { QApplication::clipboard()->setText(tabSeparated(*this)); }

}  // namespace cable_variation_rviz
