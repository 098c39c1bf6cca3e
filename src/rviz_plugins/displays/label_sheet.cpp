#include <rviz_plugins/displays/label_sheet.h>

#include <algorithm>

#include <QFont>
#include <QFontMetrics>
#include <QPainter>

namespace cable_variation_rviz {

using cable_variation::Label;

namespace {

constexpr int kWidth = 2048, kMostHeight = 2048;  // of the image [px]
constexpr int kLongest = 120;                     // text [letters]
constexpr int kDot = 9;                           // [px]
constexpr int kPatch = 4;                         // of one colour [px]
const QColor kDark(16, 18, 22), kLight(245, 246, 248), kFigure(190, 228, 255), kFault(176, 12, 20);

QFont fontOf(const LabelStyle& style) {
  QFont font;
  font.setPixelSize(style.text_height);
  font.setWeight(QFont::DemiBold);
  return font;
}

QString textOf(const Label& label) {
  const QString text = QString::fromStdString(label.text).simplified();
  return text.size() <= kLongest ? text : text.left(kLongest - 1) + QChar(0x2026);
}

void drawLabel(QPainter& painter, const Label& label, const QRect& box, const LabelStyle& style) {
  const bool fault = label.kind == Label::FAULT;
  QColor ground = fault ? kFault : kDark;
  if (!fault) ground.setAlphaF(style.plate_alpha);
  QColor rim = kLight;
  rim.setAlphaF(fault ? 0.9 : 0.45);
  painter.setBrush(ground);
  painter.setPen(QPen(rim, 1.0));
  painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.setPen(label.kind == Label::FIGURE ? kFigure : kLight);
  painter.drawText(box, Qt::AlignCenter, textOf(label));
}

}  // namespace

LabelSheet labelSheet(const std::vector<Label>& labels, const LabelStyle& style) {
  const QFont font = fontOf(style);
  const QFontMetrics metrics(font);
  const int pad = std::max(3, style.text_height / 3), height = metrics.height() + pad;
  LabelSheet sheet;
  sheet.dot = QRect(0, 0, kDot, kDot);
  sheet.line = QRect(kDot + 1, 0, kPatch, kPatch);
  sheet.rim = QRect(kDot + kPatch + 2, 0, kPatch, kPatch);
  int x = 0, y = kDot + 1;
  for (const Label& label : labels) {
    const int width = std::min(kWidth, metrics.horizontalAdvance(textOf(label)) + 2 * pad);
    if (x + width > kWidth) {
      x = 0;
      y += height + 1;
    }
    if (y + height > kMostHeight) break;
    sheet.texts.emplace_back(x, y, width, height);
    x += width + 1;
  }
  int rows = 64;  // a power of two, so that the texture is seldom another one
  while (rows < y + height) rows *= 2;
  sheet.image = QImage(kWidth, rows, QImage::Format_ARGB32);
  sheet.image.fill(Qt::transparent);
  QPainter painter(&sheet.image);
  painter.fillRect(sheet.line, kLight);
  painter.fillRect(sheet.rim, kDark);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::TextAntialiasing);
  painter.setPen(QPen(kDark, 1.5));
  painter.setBrush(kLight);
  painter.drawEllipse(QRectF(sheet.dot).adjusted(1.0, 1.0, -1.0, -1.0));
  painter.setFont(font);
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) drawLabel(painter, labels[i], sheet.texts[i], style);
  return sheet;
}

}  // namespace cable_variation_rviz
