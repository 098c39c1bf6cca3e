#include <rviz_plugins/panel/two_line_delegate.h>

#include <algorithm>

#include <QApplication>
#include <QPainter>

namespace cable_variation_rviz {

namespace {

constexpr int kMargin = 6;       // [px]
constexpr int kMark = 8;         // diameter of the mark [px]
constexpr double kSmall = 0.85;  // of the second line's letters

QFont small(QFont font) {
  font.setBold(false);
  font.setPointSizeF(kSmall * font.pointSizeF());
  return font;
}

}  // namespace

TwoLineDelegate::TwoLineDelegate(int detail_role, int mark_role, QObject* parent)
    : QStyledItemDelegate(parent), detail_role_(detail_role), mark_role_(mark_role) {}

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
  QStyleOptionViewItem option = given;
  initStyleOption(&option, index);
  const QString name = option.text;
  option.text.clear();
  const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

  const bool selected = (option.state & QStyle::State_Selected) != 0;
  const QPalette::ColorRole role = selected ? QPalette::HighlightedText : QPalette::Text;
  QRect inside = option.rect.adjusted(kMargin, 2, -kMargin, -2);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (index.data(mark_role_).toBool()) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(selected ? option.palette.brush(role) : QBrush(QColor(222, 120, 0)));
    painter->drawEllipse(QRect(inside.right() - kMark, inside.top() + 5, kMark, kMark));
    inside.setRight(inside.right() - kMark - 2);
  }
  const QRect upper(inside.left(), inside.top(), inside.width(), inside.height() / 2);
  const QRect lower(inside.left(), upper.bottom() + 1, given.rect.right() - kMargin - inside.left(),
                    inside.bottom() - upper.bottom());
  painter->setFont(option.font);
  painter->setPen(option.palette.color(role));
  painter->drawText(upper, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(option.font).elidedText(name, Qt::ElideRight, upper.width()));
  const QFont second = small(option.font);
  QColor faint = option.palette.color(role);
  faint.setAlphaF(0.75);
  painter->setFont(second);
  painter->setPen(faint);
  painter->drawText(
      lower, Qt::AlignLeft | Qt::AlignVCenter,
      QFontMetrics(second).elidedText(index.data(detail_role_).toString(), Qt::ElideRight, lower.width()));
  painter->restore();
}

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const {
  QStyleOptionViewItem option = given;
  initStyleOption(&option, index);
  const QFontMetrics first(option.font), second(small(option.font));
  const int width = std::max(first.horizontalAdvance(option.text) + kMark + 2,
                             second.horizontalAdvance(index.data(detail_role_).toString()));
  return {width + 2 * kMargin, first.height() + second.height() + 6};
}

}  // namespace cable_variation_rviz
