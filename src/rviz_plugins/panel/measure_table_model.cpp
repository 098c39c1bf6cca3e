#include <rviz_plugins/panel/measure_table_model.h>

#include <QBrush>
#include <QColor>
#include <QFont>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/copyable_table.h>
#include <rviz_plugins/panel/verdict.h>

namespace cable_variation_rviz {

using cable_variation::displayNumber;
using cable_variation::MeasureResult;

QString limitsText(bool has_lower, double lower, bool has_upper, double upper, const std::string& unit) {
  const auto shown = [&](double value) { return QString::fromStdString(displayNumber(value, unit)); };
  if (has_lower && has_upper) return shown(lower) + QString::fromUtf8(" \u2026 ") + shown(upper);
  if (has_lower) return QString::fromUtf8("\u2265 ") + shown(lower);
  if (has_upper) return QString::fromUtf8("\u2264 ") + shown(upper);
  return {};
}

void MeasureTableModel::setMeasures(const std::vector<MeasureResult>& measures) {
  bool same = measures.size() == measures_.size();
  for (std::size_t i = 0; same && i < measures.size(); ++i) same = measures[i].name == measures_[i].name;
  outdated_ = false;
  if (same) {  // whoever has selected a row keeps it
    measures_ = measures;
    if (!measures_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  measures_ = measures;
  endResetModel();
}

void MeasureTableModel::setOutdated(bool outdated) {
  outdated_ = outdated;
  if (!measures_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int MeasureTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(measures_.size());
}

int MeasureTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant MeasureTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const MeasureResult& measure = measures_[index.row()];
  const bool limited = measure.has_lower || measure.has_upper;
  const Verdict verdict = !limited || outdated_ ? Verdict::none
                          : measure.within      ? Verdict::good
                                                : Verdict::bad;
  switch (role) {
    case Qt::DisplayRole:
      switch (index.column()) {
        case kName:
          return signOf(verdict) + " " + QString::fromStdString(measure.name);
        case kValue:
          return QString::fromStdString(
              displayNumber(cable_variation::withoutRounding(measure.value, measure.unit), measure.unit));
        case kUnit:
          return QString::fromStdString(cable_variation::displayUnit(measure.unit).symbol);
        default:
          return limitsText(measure.has_lower, measure.lower, measure.has_upper, measure.upper, measure.unit);
      }
    case kSortRole:
      return index.column() == kValue ? QVariant(measure.value) : index.data(Qt::DisplayRole);
    case Qt::TextAlignmentRole:
      return index.column() == kValue ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
      if (outdated_) return QBrush(QColor(140, 140, 140));
      return verdict == Verdict::none || index.column() > kValue ? QVariant() : QBrush(colourOf(verdict));
    case Qt::FontRole: {
      QFont font;
      font.setBold(verdict == Verdict::bad);
      return font;
    }
    case Qt::ToolTipRole: {
      QString text = QString::fromStdString(measure.name + ": " + measure.type).replace('_', ' ');
      if (limited && !outdated_) text += measure.within ? ", within its limits" : ", beyond its limit";
      if (measure.has_place) {
        text += QString("\nat %1 of %2")
                    .arg(QString::fromStdString(cable_variation::displayValue(measure.arc_length, "m")),
                         QString::fromStdString(measure.cable));
      }
      if (!measure.note.empty()) text += "\n" + QString::fromStdString(measure.note);
      return text;
    }
    default:
      return {};
  }
}

QVariant MeasureTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const char* const names[kColumns] = {"Measure", "Value", "Unit", "Limits"};
  return QString(names[section]);
}

}  // namespace cable_variation_rviz
