#pragma once

#include <QHeaderView>

namespace cable_variation_rviz {

/// The header of narrow columns: their names stand upright, read from below.
class RotatedHeader : public QHeaderView {
  Q_OBJECT

 public:
  explicit RotatedHeader(QWidget* parent = nullptr);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  QSize sectionSizeFromContents(int section) const override;
};

}  // namespace cable_variation_rviz
