#pragma once

#include <QTableView>

namespace cable_variation_rviz {

class VariableTableModel;

/// Design variables with a slider and a value to be typed each, and a button that resets it. As high as its
/// rows want to be, as wide as it is given: names are shortened first.
class VariableTable : public QTableView {
  Q_OBJECT

 public:
  explicit VariableTable(VariableTableModel* variables, QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(int row);  ///< by a click on its name
  void resetRequested(int row);

 private:
  void openSliders();
  void showResets();

  VariableTableModel* variables_;
};

}  // namespace cable_variation_rviz
