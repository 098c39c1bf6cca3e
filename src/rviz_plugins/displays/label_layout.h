#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace cable_variation_rviz {

/// A label to be placed. All in pixels from the view's top left corner.
struct LabelWish {
  QPointF anchor;  ///< what it is about
  QSizeF size;
  int rank = 0;  ///< lower ones choose first
};

/// Finds places for labels beside their anchors so that none covers another, as near as there is room. A
/// label keeps to the side that it was on while there is room, so that it does not jump while the camera
/// moves.
class LabelLayout {
 public:
  /// A place for each label; none: its anchor is out of view, or there is no room for it.
  /// @param step between distances tried [px]
  /// @param covered where there is something else, as a legend
  std::vector<std::optional<QRectF>> place(const std::vector<LabelWish>& wishes, QSizeF view, double step,
                                           const std::vector<QRectF>& covered = {});
  /// The labels are others now.
  void forget() { sides_.clear(); }

 private:
  std::vector<std::optional<std::size_t>> sides_;  ///< of each label: the number of the place it took
};

}  // namespace cable_variation_rviz
