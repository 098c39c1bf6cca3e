#include <rviz_plugins/panel/histogram_plot.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include <cable_variation/util/display_unit.h>
#include <rviz_plugins/panel/verdict.h>
#include <rviz_plugins/ticks.h>

namespace cable_variation_rviz {

using cable_variation::displayNumber;
using cable_variation::displayUnit;

namespace {

const QColor kBar(70, 110, 160), kMean(20, 20, 20), kGround(255, 255, 255), kAxis(110, 110, 110);

}  // namespace

HistogramPlot::HistogramPlot(cable_variation::MeasureStatisticsResult statistics, QWidget* parent)
    : QWidget(parent), statistics_(std::move(statistics)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(QString("%1 samples; lines: limits (red), mean (solid), three standard deviations (dotted)")
                 .arg(statistics_.count));
}

QSize HistogramPlot::sizeHint() const { return {240, 11 * fontMetrics().lineSpacing()}; }

QString HistogramPlot::title() const {
  const auto shown = [&](double value) {
    return QString::fromStdString(displayNumber(value, statistics_.unit, 4));
  };
  QString text = QString::fromUtf8("mean %1, \u03c3 %2 %3")
                     .arg(shown(statistics_.best_mean), shown(statistics_.best_sigma),
                          QString::fromStdString(displayUnit(statistics_.unit).symbol));
  if (statistics_.has_capability && std::isfinite(statistics_.capability.cpk)) {
    text += QString(", Cpk %1").arg(statistics_.capability.cpk, 0, 'f', 2);
  }
  return text;
}

void HistogramPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int line = fontMetrics().lineSpacing();
  painter.fillRect(rect(), kGround);
  painter.setPen(Qt::black);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  const int margin = 8;
  painter.drawText(margin, line, QString::fromStdString(statistics_.name));
  painter.setFont(font());
  painter.drawText(QRect(margin, line + 2, width() - 2 * margin, line), Qt::AlignLeft, title());

  const auto& counts = statistics_.histogram_count;
  const QRectF plot(margin, 2.5 * line, width() - 2 * margin, height() - 4.0 * line);
  if (counts.empty() || !(statistics_.histogram_width > 0.0)) {
    painter.drawText(plot, Qt::AlignCenter, "too few different values");
    return;
  }
  const double factor = displayUnit(statistics_.unit).factor;
  double low = statistics_.histogram_low;
  double high = low + statistics_.histogram_width * static_cast<double>(counts.size());
  // A limit is on the plot if that leaves at least a third of its width to the bars.
  const double most = 2.0 * (high - low);
  if (statistics_.has_lower && statistics_.lower < low && low - statistics_.lower < most)
    low = statistics_.lower;
  if (statistics_.has_upper && statistics_.upper > high && statistics_.upper - high < most) {
    high = statistics_.upper;
  }
  const double room = 0.03 * (high - low);
  low -= room;
  high += room;
  const auto x = [&](double value) { return plot.left() + plot.width() * (value - low) / (high - low); };
  const double tallest = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double from = statistics_.histogram_low + statistics_.histogram_width * static_cast<double>(i);
    const double to = from + statistics_.histogram_width, middle = 0.5 * (from + to);
    const bool beyond = (statistics_.has_lower && middle < statistics_.lower) ||
                        (statistics_.has_upper && middle > statistics_.upper);
    const double height = plot.height() * static_cast<double>(counts[i]) / tallest;
    painter.fillRect(QRectF(x(from), plot.bottom() - height, std::max(1.0, x(to) - x(from) - 1.0), height),
                     beyond ? colourOf(Verdict::bad) : kBar);
  }
  painter.setPen(kAxis);
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  const auto drawLine = [&](double value, const QColor& colour, Qt::PenStyle style) {
    if (!std::isfinite(value) || value < low || value > high) return;
    painter.setPen(QPen(colour, 2.0, style));
    painter.drawLine(QPointF(x(value), plot.top()), QPointF(x(value), plot.bottom()));
  };
  drawLine(statistics_.best_mean, kMean, Qt::SolidLine);
  drawLine(statistics_.best_mean - 3.0 * statistics_.best_sigma, kMean, Qt::DotLine);
  drawLine(statistics_.best_mean + 3.0 * statistics_.best_sigma, kMean, Qt::DotLine);
  if (statistics_.has_lower) drawLine(statistics_.lower, colourOf(Verdict::bad), Qt::DashLine);
  if (statistics_.has_upper) drawLine(statistics_.upper, colourOf(Verdict::bad), Qt::DashLine);

  painter.setPen(Qt::black);
  double free_from = plot.left() - margin;
  for (const Tick& tick : ticks(factor * (low + room), factor * (high - room), 4)) {
    const double at = x(tick.value / factor), wide = fontMetrics().horizontalAdvance(tick.label);
    const double left = std::clamp(at - 0.5 * wide, plot.left() - margin, plot.right() + margin - wide);
    if (left < free_from) continue;
    painter.drawText(QPointF(left, plot.bottom() + line), tick.label);
    free_from = left + wide + fontMetrics().averageCharWidth();
  }
}

}  // namespace cable_variation_rviz
