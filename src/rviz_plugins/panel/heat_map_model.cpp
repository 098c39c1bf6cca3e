#include <rviz_plugins/panel/heat_map_model.h>

#include <cmath>

#include <QBrush>

namespace cable_variation_rviz {

void HeatMapModel::setMatrix(const ContributionMatrix& matrix) {
  beginResetModel();
  matrix_ = matrix;
  endResetModel();
}

int HeatMapModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(matrix_.variables.size());
}

int HeatMapModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(matrix_.measures.size());
}

QVariant HeatMapModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const std::size_t at = index.column() * matrix_.variables.size() + index.row();
  const double share = at < matrix_.share.size() ? matrix_.share[at] : std::nan("");
  switch (role) {
    case Qt::DisplayRole:
      if (std::isnan(share)) return QString("-");
      return share != 0.0 && share < 0.005 ? QString("<1") : QString::number(std::lround(100.0 * share));
    case kSortRole:
      return std::isnan(share) ? -1.0 : share;
    case Qt::BackgroundRole:
      return QBrush(heatColour(share));
    case Qt::ForegroundRole:
      return QBrush(lettersOn(heatColour(share)));
    case Qt::TextAlignmentRole:
      return Qt::AlignCenter;
    case Qt::ToolTipRole: {
      QString text = QString("%1 in %2: %3 % of the variance")
                         .arg(QString::fromStdString(matrix_.variables[index.row()]),
                              QString::fromStdString(matrix_.measures[index.column()]))
                         .arg(100.0 * share, 0, 'g', 3);
      if (at < matrix_.derivative.size()) text += QString("\nderivative %1 (SI)").arg(matrix_.derivative[at]);
      return text;
    }
    default:
      return {};
  }
}

QVariant HeatMapModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  const auto& names = orientation == Qt::Horizontal ? matrix_.measures : matrix_.variables;
  return static_cast<std::size_t>(section) < names.size() ? QString::fromStdString(names[section])
                                                          : QVariant();
}

}  // namespace cable_variation_rviz
