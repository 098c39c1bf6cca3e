#pragma once

#include <vector>

#include <QAbstractTableModel>

#ifndef Q_MOC_RUN
#include <cable_variation/MeasureResult.h>
#endif

namespace cable_variation_rviz {

/// "≥ 5", "≤ 10", "-90 … 90" in the unit shown; empty: no limit.
QString limitsText(bool has_lower, double lower, bool has_upper, double upper, const std::string& unit);

/// Measures as they are now, one a row: whether the limits are kept, as a sign and a colour, value, unit,
/// limits.
class MeasureTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kUnit, kLimits, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  void setMeasures(const std::vector<cable_variation::MeasureResult>& measures);
  /// Values are out of date: shown grey, without a verdict.
  void setOutdated(bool outdated);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<cable_variation::MeasureResult> measures_;
  bool outdated_ = false;
};

}  // namespace cable_variation_rviz
