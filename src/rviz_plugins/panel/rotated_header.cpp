#include <rviz_plugins/panel/rotated_header.h>

#include <QPainter>

namespace cable_variation_rviz {

namespace {

constexpr int kMargin = 6;  // [px]

}  // namespace

RotatedHeader::RotatedHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setSectionsClickable(true);
  setHighlightSections(false);
}

void RotatedHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const QString text = model()->headerData(section, orientation()).toString();
  painter->save();
  painter->fillRect(rect, palette().button());
  painter->setPen(palette().color(QPalette::Mid));
  painter->drawLine(rect.topRight(), rect.bottomRight());
  painter->setPen(palette().color(QPalette::ButtonText));
  painter->translate(rect.left(), rect.bottom());
  painter->rotate(-90.0);
  painter->drawText(QRect(kMargin, 0, rect.height() - 2 * kMargin, rect.width()),
                    Qt::AlignLeft | Qt::AlignVCenter, text);
  painter->restore();
}

QSize RotatedHeader::sectionSizeFromContents(int section) const {
  const QString text = model()->headerData(section, orientation()).toString();
  return {fontMetrics().height() + kMargin, fontMetrics().horizontalAdvance(text) + 3 * kMargin};
}

}  // namespace cable_variation_rviz
