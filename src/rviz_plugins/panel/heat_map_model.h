#pragma once

#include <QAbstractTableModel>

#include <rviz_plugins/panel/heat_map.h>

namespace cable_variation_rviz {

/// A row per variable, a column per measure, the share in per cent as text, its colour as background.
class HeatMapModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  void setMatrix(const ContributionMatrix& matrix);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  ContributionMatrix matrix_;
};

}  // namespace cable_variation_rviz
