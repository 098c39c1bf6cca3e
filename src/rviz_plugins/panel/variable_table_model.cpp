#include <rviz_plugins/panel/variable_table_model.h>

#include <algorithm>
#include <stdexcept>

#include <QFont>

#include <cable_variation/util/display_unit.h>

namespace cable_variation_rviz {

using cable_variation::DesignVariableInfo;

QString descriptionOf(const DesignVariableInfo& variable) {
  const QString target = QString::fromStdString(variable.target);
  const QString member = QString::fromStdString(variable.member);
  if (variable.kind == "clip_translation")
    return QString("displacement of clip %1 along its %2").arg(target, member);
  if (variable.kind == "clip_rotation")
    return QString("rotation of clip %1 about its %2").arg(target, member);
  if (variable.kind == "clip_arc_length") return QString("place of clip %1 along the cable").arg(target);
  if (variable.kind == "cable_property")
    return QString("%2 of cable %1").arg(target, member).replace('_', ' ');
  if (variable.kind == "breakout_arc_length") return QString("place of breakout %1").arg(target);
  if (variable.kind == "component_translation")
    return QString("displacement of %1 along %2").arg(target, member);
  if (variable.kind == "component_rotation") return QString("rotation of %1 about %2").arg(target, member);
  if (variable.kind == "locator_deviation")
    return QString("deviation of locator %2 of %1").arg(target, member);
  return QString::fromStdString(variable.kind).replace('_', ' ') + " " + target;
}

void VariableTableModel::setVariables(const std::vector<DesignVariableInfo>& variables) {
  beginResetModel();
  variables_.clear();
  for (const DesignVariableInfo& info : variables) variables_.push_back({info, info.nominal, info.nominal});
  endResetModel();
}

void VariableTableModel::setState(const cable_variation::DesignState& state) {
  for (std::size_t i = 0; i < state.variables.size(); ++i) {
    const auto found = std::find_if(variables_.begin(), variables_.end(),
                                    [&](const Row& row) { return row.info.name == state.variables[i]; });
    if (found == variables_.end()) continue;
    found->value = state.nominal[i];
    found->loaded = state.loaded[i];
  }
  if (!variables_.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  }
}

void VariableTableModel::edit(int row, double value) {
  variables_[row].value = value;
  Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
  Q_EMIT designEdited(row, value);
}

int VariableTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(variables_.size());
}

int VariableTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant VariableTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = variables_[index.row()];
  const auto shown = [&](double value, int digits) {
    return QString::fromStdString(cable_variation::displayValue(value, row.info.unit, digits));
  };
  const double low = row.loaded + row.info.lower, high = row.loaded + row.info.upper;
  switch (role) {
    case kDescription:
      return descriptionOf(row.info);
    case kChanged:
      return changed(index.row());
    case kShare:
      return high > low ? std::clamp((row.value - low) / (high - low), 0.0, 1.0) : 0.5;
    case Qt::EditRole:
    case Qt::DisplayRole:
      if (index.column() == kName) return QString::fromStdString(row.info.name);
      if (index.column() == kValue) return shown(row.value, 6);
      return {};
    case Qt::ToolTipRole: {
      QString text = QString("%1\n%2\ntolerance %3 to %4, %5")
                         .arg(QString::fromStdString(row.info.name), descriptionOf(row.info), shown(low, 6),
                              shown(high, 6), QString::fromStdString(row.info.distribution));
      if (changed(index.row())) text += "\nchanged: the scene has " + shown(row.loaded, 6);
      return text;
    }
    case Qt::TextAlignmentRole:
      return index.column() == kValue ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::FontRole: {
      QFont font;
      font.setBold(changed(index.row()) && index.column() != kSlider);
      return font;
    }
    default:
      return {};
  }
}

QVariant VariableTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const char* const names[kColumns] = {"Variable", "Tolerance", "Value", ""};
  return QString(names[section]);
}

Qt::ItemFlags VariableTableModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  const bool editable = index.column() == kSlider || index.column() == kValue;
  return editable ? flags | Qt::ItemIsEditable : flags;
}

bool VariableTableModel::setData(const QModelIndex& index, const QVariant& data, int role) {
  if (!index.isValid() || role != Qt::EditRole) return false;
  const Row& row = variables_[index.row()];
  if (index.column() == kSlider) {
    const double value = row.loaded + row.info.lower + data.toDouble() * (row.info.upper - row.info.lower);
    edit(index.row(), value);
    return true;
  }
  if (index.column() != kValue) return false;
  if (data.toString() == this->data(index, Qt::EditRole).toString()) return true;  // left as it was
  try {
    edit(index.row(), cable_variation::parseDisplayed(data.toString().toStdString(), row.info.unit));
  } catch (const std::invalid_argument& error) {
    Q_EMIT refused(QString::fromStdString(row.info.name + ": " + error.what()));
    return false;
  }
  return true;
}

}  // namespace cable_variation_rviz
