#pragma once

#include <string>
#include <vector>

#include <rviz_plugins/panel/copyable_table.h>

namespace cable_variation_rviz {

class HeatMapModel;

/// Which variable drives which measure.
struct ContributionMatrix {
  std::vector<std::string> variables;  ///< rows here
  std::vector<std::string> measures;   ///< columns here
  std::vector<double> share;       ///< in the variance of the measure [1], measures x variables, row by row
  std::vector<double> derivative;  ///< likewise, for the tool tip; empty: none
};

/// A matrix of shares as colours (viridis from 0 to 100 %) with the numbers on them, readable on each. To be
/// sorted by a measure and copied as a table is.
class HeatMap : public CopyableTable {
  Q_OBJECT

 public:
  explicit HeatMap(QWidget* parent = nullptr);
  void setMatrix(const ContributionMatrix& matrix);

 Q_SIGNALS:
  void variableChosen(const QString& name);

 private:
  HeatMapModel* matrix_;
};

/// The colour of a share, and one for letters on it.
QColor heatColour(double share);
QColor lettersOn(const QColor& ground);

}  // namespace cable_variation_rviz
