#pragma once

#include <vector>

#include <QAbstractTableModel>

#ifndef Q_MOC_RUN
#include <cable_variation/DesignState.h>
#include <cable_variation/DesignVariableInfo.h>
#endif

namespace cable_variation_rviz {

/// What a design variable is, in words: "rotation of clip WH_Start about its x".
QString descriptionOf(const cable_variation::DesignVariableInfo& variable);

/// Design variables of a scene, one a row: name and what it is, its place within the tolerance, its value.
/// Values are SI inside, and shown and typed in mm or deg.
class VariableTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kSlider, kValue, kReset, kColumns };
  enum Role { kDescription = Qt::UserRole, kChanged, kShare };  ///< kShare: of the tolerance, 0 to 1

  using QAbstractTableModel::QAbstractTableModel;

  /// Other variables: those of another scene.
  void setVariables(const std::vector<cable_variation::DesignVariableInfo>& variables);
  /// Values that are in force. A variable that `state` does not have keeps its own.
  void setState(const cable_variation::DesignState& state);
  /// A person's own value, which designEdited() tells of.
  void edit(int row, double value);
  /// Back to what the scene file has.
  void reset(int row) { edit(row, variables_[row].loaded); }

  const cable_variation::DesignVariableInfo& variable(int row) const { return variables_[row].info; }
  double value(int row) const { return variables_[row].value; }
  bool changed(int row) const { return variables_[row].value != variables_[row].loaded; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Of kValue a text with or without a unit; of kSlider the share of the tolerance.
  bool setData(const QModelIndex& index, const QVariant& data, int role) override;

 Q_SIGNALS:
  void designEdited(int row, double value);
  void refused(const QString& message);  ///< of what was typed

 private:
  struct Row {
    cable_variation::DesignVariableInfo info;
    double value = 0.0;   ///< in force, or just edited
    double loaded = 0.0;  ///< as the scene file has it
  };
  std::vector<Row> variables_;
};

}  // namespace cable_variation_rviz
