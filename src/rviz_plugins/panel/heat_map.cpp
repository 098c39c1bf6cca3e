#include <rviz_plugins/panel/heat_map.h>

#include <cmath>

#include <ros_interface/markers/colour_map.h>
#include <rviz_plugins/panel/heat_map_model.h>
#include <rviz_plugins/panel/rotated_header.h>

namespace cable_variation_rviz {

HeatMap::HeatMap(QWidget* parent) : CopyableTable(parent), matrix_(new HeatMapModel(this)) {
  setObjectName("heat_map");
  auto* header = new RotatedHeader(this);
  setHorizontalHeader(header);
  sortOn(header);
  show(matrix_);
  setAlternatingRowColors(false);
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setDefaultSectionSize(fontMetrics().horizontalAdvance("100") + 10);
  verticalHeader()->show();
  verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  verticalHeader()->setSectionsClickable(true);
  const auto choose = [this](int row) {
    Q_EMIT variableChosen(model()->headerData(row, Qt::Vertical).toString());
  };
  connect(verticalHeader(), &QHeaderView::sectionClicked, this, choose);
  connect(this, &QTableView::clicked, this, [choose](const QModelIndex& index) { choose(index.row()); });
}

void HeatMap::setMatrix(const ContributionMatrix& matrix) { matrix_->setMatrix(matrix); }

QColor heatColour(double share) {
  const Eigen::Vector3d colour = cable_variation_ros::viridis(share);
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

QColor lettersOn(const QColor& ground) {
  // Relative luminance of sRGB (WCAG 2): the one of black and white with the greater contrast.
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double luminance =
      0.2126 * linear(ground.redF()) + 0.7152 * linear(ground.greenF()) + 0.0722 * linear(ground.blueF());
  return luminance > 0.179 ? Qt::black : Qt::white;
}

}  // namespace cable_variation_rviz
