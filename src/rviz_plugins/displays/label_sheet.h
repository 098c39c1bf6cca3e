#pragma once

#include <vector>

#include <QImage>
#include <QRect>

#include <cable_variation/Label.h>

namespace cable_variation_rviz {

/// How labels look.
struct LabelStyle {
  int text_height = 15;      ///< [px]
  double plate_alpha = 0.8;  ///< of the plate behind a text; that of faults is opaque
};

/// Labels drawn on one image: light letters, each text on a dark plate of its own with a light rim, faults on
/// a red one. Besides them what leads from a label to its place.
struct LabelSheet {
  QImage image;
  std::vector<QRect> texts;  ///< of the image; as many labels as fit it
  QRect dot;                 ///< for the place
  QRect line, rim;           ///< light and dark, all of one colour
};
LabelSheet labelSheet(const std::vector<cable_variation::Label>& labels, const LabelStyle& style);

}  // namespace cable_variation_rviz
