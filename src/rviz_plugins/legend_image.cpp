#include <rviz_plugins/legend_image.h>

#include <algorithm>
#include <cmath>

#include <QFont>
#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

#include <rviz_plugins/ticks.h>

namespace cable_variation_rviz {

namespace {

const QColor kGround(16, 18, 22, 190);
const QColor kText(240, 240, 240);

constexpr int kMostInnerTicks = 5;
constexpr int kBarLines = 10;    // height of the bar in lines of text
constexpr int kWidestText = 16;  // widest line in text heights; longer ones are wrapped

QString unitText(const cable_variation::Legend& legend) {
  const QString quantity = QString::fromStdString(legend.quantity);
  if (legend.unit.empty() || legend.unit == "1") return quantity;
  return quantity + " [" + QString::fromStdString(legend.unit) + "]";
}

QString originText(const cable_variation::Legend& legend) {
  if (legend.samples == 0) return "computed, first order";
  return QLocale(QLocale::English).toString(legend.samples) + (legend.samples == 1 ? " sample" : " samples");
}

/// A piece of text with its place below those added before.
class Column {
 public:
  Column(int width, int spacing) : width_(width), spacing_(spacing) {}

  void add(const QString& text, const QFont& font) {
    if (text.isEmpty()) return;
    const QRect bounds(0, height_, width_, 100 * font.pixelSize());
    const QRect needed = QFontMetrics(font).boundingRect(bounds, Qt::TextWordWrap, text);
    pieces_.push_back({text, font, needed});
    widest_ = std::max(widest_, needed.width());
    height_ += needed.height() + spacing_;
  }

  int width() const { return widest_; }
  int height() const { return height_; }

  void draw(QPainter& painter, int left, int top) const {
    for (const Piece& piece : pieces_) {
      painter.setFont(piece.font);
      painter.drawText(piece.place.translated(left, top).adjusted(0, 0, piece.font.pixelSize(), 0),
                       Qt::TextWordWrap, piece.text);
    }
  }

 private:
  struct Piece {
    QString text;
    QFont font;
    QRect place;
  };
  std::vector<Piece> pieces_;
  int width_;
  int spacing_;
  int widest_ = 0;
  int height_ = 0;
};

void drawBar(QPainter& painter, const QRect& bar, const cable_variation::Legend& legend, ColourMap map) {
  for (int row = 0; row < bar.height(); ++row) {
    const bool flat = !(legend.maximum > legend.minimum);
    const Eigen::Vector3d color =
        mapped(map, flat ? 0.0 : bar.height() - 1 - row, 0.0, std::max(1, bar.height() - 1));
    painter.fillRect(bar.left(), bar.top() + row, bar.width(), 1,
                     QColor::fromRgbF(color[0], color[1], color[2]));
  }
}

}  // namespace

QImage legendImage(const cable_variation::Legend& legend, int text_height, ColourMap map,
                   const QString& origin) {
  QFont font;
  font.setPixelSize(text_height);
  QFont bold = font, small = font;
  bold.setBold(true);
  small.setPixelSize(std::max(8, text_height * 5 / 6));
  const QFontMetrics metrics(font);
  const int gap = text_height / 2;

  Column head(kWidestText * text_height, gap / 2), foot(kWidestText * text_height, gap / 2);
  head.add(QString::fromStdString(legend.title), bold);
  head.add(unitText(legend), font);
  foot.add(origin.isEmpty() ? originText(legend) : origin, small);
  foot.add(QString::fromStdString(legend.note), small);

  const std::vector<Tick> numbers = ticks(legend.minimum, legend.maximum, kMostInnerTicks);
  int label_width = 0;
  for (const Tick& tick : numbers) label_width = std::max(label_width, metrics.horizontalAdvance(tick.label));

  // Room above and below the bar for half of the outer labels.
  const QRect bar(gap, gap + head.height() + metrics.height() / 2, text_height * 3 / 2,
                  kBarLines * text_height);
  const int tick_length = gap / 2;
  const int right_of_bar = bar.right() + 1 + 2 * tick_length;
  const int content = std::max({head.width(), foot.width(), right_of_bar + label_width - gap});
  const int foot_top = bar.bottom() + 1 + metrics.height() / 2 + gap / 2;
  QImage image(content + 2 * gap, foot_top + foot.height() + gap / 2, QImage::Format_ARGB32);
  image.fill(Qt::transparent);

  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::TextAntialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kGround);
  painter.drawRoundedRect(image.rect(), gap, gap);
  painter.setPen(kText);
  head.draw(painter, gap, gap);
  foot.draw(painter, gap, foot_top);
  drawBar(painter, bar, legend, map);

  painter.setFont(font);
  const double range = legend.maximum - legend.minimum;
  for (const Tick& tick : numbers) {
    const double share = range > 0.0 ? (tick.value - legend.minimum) / range : 0.5;
    const int y = bar.bottom() - static_cast<int>(std::lround(share * (bar.height() - 1)));
    painter.fillRect(bar.right() + 1, y, tick_length, 1, kText);
    painter.drawText(right_of_bar, y + (metrics.ascent() - metrics.descent()) / 2 + 1, tick.label);
  }
  return image;
}

}  // namespace cable_variation_rviz
