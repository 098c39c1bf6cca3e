#include <cable_variation/report/profile_chart.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/report/chart_axis.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/svg.h>

namespace cable_variation {

namespace {

constexpr double kLeft = 58.0, kPlot = 372.0, kRight = 14.0;                   // [px]
constexpr double kTop = 38.0, kHeight = 150.0, kBottom = 40.0, kLetter = 6.6;  // [px]
constexpr double kInf = std::numeric_limits<double>::infinity();

class Scales {
 public:
  explicit Scales(const ProfileChart& chart) {
    double left = kInf, right = -kInf, low = chart.least, high = -kInf;
    for (const ProfileLine& line : chart.lines) {
      for (const auto& [x, y] : line.points) {
        left = std::min(left, x);
        right = std::max(right, x);
        if (!std::isfinite(y)) continue;
        low = std::min(low, y);
        high = std::max(high, y);
      }
    }
    for (const auto& limit : chart.limits) {
      // one far off would flatten all lines
      if (limit.first <= 2.0 * high - low) high = std::max(high, limit.first);
    }
    if (chart.most > 0.0) high = std::min(high, chart.most);
    if (!(high > low)) high = low + 1.0;
    if (!(left <= right)) left = 0.0, right = 1.0;
    y_ = roundAxis(low, high, 4);
    x_ = roundAxis(std::min(left, right), std::max(left, right), 6);
    if (std::isfinite(left) && right > left) {  // along the cable to its very end
      x_.low = left;
      x_.high = right;
    }
  }

  const ChartAxis& x() const { return x_; }
  const ChartAxis& y() const { return y_; }
  double left(double value) const { return kLeft + kPlot * x_.share(value); }
  double top(double value) const { return kTop + kHeight * (1.0 - y_.share(value)); }
  bool shows(double y) const { return y >= y_.low && y <= y_.high; }

 private:
  ChartAxis x_, y_;
};

std::string axes(const ProfileChart& chart, const Scales& scales) {
  const double base = kTop + kHeight;
  std::string content;
  for (const double tick : scales.y().ticks) {
    content += svg::line(kLeft, scales.top(tick), kLeft + kPlot, scales.top(tick), "stroke:var(--rule)");
    content += svg::text(kLeft - 6.0, scales.top(tick) + 4.0, "end", figure(tick));
  }
  for (const double tick : scales.x().ticks) {
    if (tick < scales.x().low || tick > scales.x().high) continue;
    content += svg::line(scales.left(tick), base, scales.left(tick), base + 4.0, "stroke:var(--ink)");
    content += svg::text(scales.left(tick), base + 17.0, "middle", figure(tick));
  }
  content += svg::line(kLeft, base, kLeft + kPlot, base, "stroke:var(--ink)");
  content += svg::text(kLeft + 0.5 * kPlot, base + 34.0, "middle", chart.x_title);
  content += svg::text(2.0, 12.0, "start", chart.y_title);
  return content;
}

/// Names of places, where there is room for them.
std::string marks(const ProfileChart& chart, const Scales& scales) {
  std::string content;
  double free_from = 0.0;
  for (const auto& [place, name] : chart.marks) {
    const double x = scales.left(place);
    content += svg::line(x, kTop, x, kTop + kHeight, "stroke:var(--faint);stroke-dasharray:2 3");
    const double width = kLetter * static_cast<double>(name.size());
    const double left = std::clamp(x - 0.5 * width, kLeft, std::max(kLeft, kLeft + kPlot + kRight - width));
    if (left < free_from) continue;
    content += svg::text(left, kTop - 6.0, "start", name);
    free_from = left + width + 6.0;
  }
  return content;
}

std::string curve(const ProfileLine& line, const Scales& scales) {
  std::string content, points;
  const auto end = [&] {
    if (!points.empty()) {
      content +=
          "<polyline points=\"" + points + "\" style=\"fill:none;stroke-width:1.6;" + line.style + "\"/>\n";
    }
    points.clear();
  };
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double x = line.points[i].first, y = line.points[i].second;
    if (!std::isfinite(y) || y < scales.y().low) {
      end();
      continue;
    }
    if (scales.shows(y)) {
      points += svg::pixels(scales.left(x)) + "," + svg::pixels(scales.top(y)) + " ";
      continue;
    }
    // Off the scale: drawn to where it leaves, and from where it comes back.
    const auto crossing = [&](std::size_t from) {
      const auto& [x1, y1] = line.points[from];
      const double t = std::isfinite(y1) && y1 != y ? (scales.y().high - y1) / (y - y1) : 1.0;
      return svg::pixels(scales.left(x1 + t * (x - x1))) + "," + svg::pixels(scales.top(scales.y().high)) +
             " ";
    };
    if (!points.empty()) points += crossing(i - 1);
    end();
    if (i + 1 < line.points.size() && scales.shows(line.points[i + 1].second)) points += crossing(i + 1);
  }
  end();
  return content;
}

std::string legend(const ProfileChart& chart) {
  if (chart.lines.size() < 2) return "";
  std::string content;
  double right = kLeft + kPlot + kRight;
  for (auto line = chart.lines.rbegin(); line != chart.lines.rend(); ++line) {
    const double width = kLetter * static_cast<double>(line->label.size());
    content += svg::text(right, 12.0, "end", line->label);
    content +=
        svg::line(right - width - 24.0, 8.0, right - width - 6.0, 8.0, "stroke-width:1.6;" + line->style);
    right -= width + 36.0;
  }
  return content;
}

}  // namespace

std::string profileChart(const ProfileChart& chart) {
  const Scales scales(chart);
  std::string content = axes(chart, scales) + marks(chart, scales);
  for (const auto& [value, name] : chart.limits) {
    if (!scales.shows(value)) continue;
    content += svg::line(kLeft, scales.top(value), kLeft + kPlot, scales.top(value),
                         "stroke:var(--bad);stroke-dasharray:5 3");
    content += svg::text(kLeft + kPlot - 4.0, scales.top(value) - 4.0, "end", name);
  }
  for (const ProfileLine& line : chart.lines) content += curve(line, scales);
  return svg::element(kLeft + kPlot + kRight, kTop + kHeight + kBottom, content + legend(chart));
}

}  // namespace cable_variation
