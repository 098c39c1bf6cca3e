#pragma once

#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QStringList>

#include <rviz_plugins/panel/verdict.h>

namespace cable_variation_rviz {

/// A cell of a result: its text, what it is sorted by, and what a tool tip adds.
struct ResultCell {
  QString text;
  QVariant sorted_by;  ///< invalid: the text
  QString tip;
  bool number = false;              ///< flush right
  Verdict verdict = Verdict::none;  ///< colours it, and puts its sign before the text
};

ResultCell textCell(const std::string& text, const QString& tip = {});
/// In the unit shown, without it: the header has it.
ResultCell numberCell(double value, const std::string& si_unit, int digits = 4);
/// The name of a column with the unit shown: "length [mm]".
QString headerWithUnit(const QString& name, const std::string& si_unit);

/// A table of results, of any analysis.
class ResultModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// @param rows each of as many cells as there are headers
  void setTable(const QStringList& headers, std::vector<std::vector<ResultCell>> rows);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QStringList headers_;
  std::vector<std::vector<ResultCell>> rows_;
};

}  // namespace cable_variation_rviz
