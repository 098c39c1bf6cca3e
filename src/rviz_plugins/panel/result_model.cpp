#include <rviz_plugins/panel/result_model.h>

#include <utility>

#include <QBrush>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>

namespace cable_variation_rviz {

ResultCell textCell(const std::string& text, const QString& tip) {
  ResultCell cell;
  cell.text = QString::fromStdString(text);
  cell.tip = tip;
  return cell;
}

ResultCell numberCell(double value, const std::string& si_unit, int digits) {
  ResultCell cell;
  cell.text = QString::fromStdString(cable_variation::displayNumber(value, si_unit, digits));
  cell.sorted_by = value;
  cell.number = true;
  return cell;
}

QString headerWithUnit(const QString& name, const std::string& si_unit) {
  return name + " [" + QString::fromStdString(cable_variation::displayUnit(si_unit).symbol) + "]";
}

void ResultModel::setTable(const QStringList& headers, std::vector<std::vector<ResultCell>> rows) {
  beginResetModel();
  headers_ = headers;
  rows_ = std::move(rows);
  endResetModel();
}

int ResultModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ResultModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : headers_.size();
}

QVariant ResultModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ResultCell& cell = rows_[index.row()][index.column()];
  switch (role) {
    case Qt::DisplayRole:
      return cell.verdict == Verdict::none ? cell.text : signOf(cell.verdict) + " " + cell.text;
    case kSortRole:
      return cell.sorted_by.isValid() ? cell.sorted_by : QVariant(cell.text);
    case Qt::ToolTipRole:
      return cell.tip.isEmpty() ? QVariant() : QVariant(cell.tip);
    case Qt::TextAlignmentRole:
      return cell.number ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
      return cell.verdict == Verdict::none ? QVariant() : QBrush(colourOf(cell.verdict));
    default:
      return {};
  }
}

QVariant ResultModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return headers_.value(section);
}

}  // namespace cable_variation_rviz
