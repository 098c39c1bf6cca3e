#include <cable_variation/report/histogram_chart.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/svg.h>

namespace cable_variation {

namespace {

constexpr double kSide = 30.0, kPlot = 330.0, kTop = 20.0, kHeight = 150.0, kBottom = 24.0;  // [px]
constexpr const char* kLimitColor = "var(--bad)";

// What is drawn: the bins, and limits and nominal nearby; those far off would flatten the bins.
class Axis {
 public:
  Axis(const Histogram& histogram, const HistogramMarks& marks)
      : low_(histogram.low),
        high_(histogram.low + histogram.width * static_cast<double>(histogram.counts.size())) {
    if (!(high_ > low_)) {
      const double half = std::max(1e-3 * std::abs(low_), 1e-12);  // all values are alike
      low_ -= half;
      high_ += half;
    }
    const double range = high_ - low_, low = low_, high = high_;
    for (const std::optional<double>& mark :
         {marks.lower, marks.upper, std::optional<double>(marks.nominal)}) {
      if (!mark || !(*mark > low - range && *mark < high + range)) continue;
      low_ = std::min(low_, *mark);
      high_ = std::max(high_, *mark);
    }
  }

  double low() const { return low_; }
  double high() const { return high_; }
  bool shows(double value) const { return value >= low_ && value <= high_; }
  double place(double value) const { return kSide + kPlot * (value - low_) / (high_ - low_); }

 private:
  double low_, high_;
};

std::string bars(const Histogram& histogram, const HistogramMarks& marks, const Axis& axis, double most) {
  std::string content;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    const double from = histogram.low + histogram.width * static_cast<double>(i), to = from + histogram.width;
    const bool outside = (marks.lower && to <= *marks.lower) || (marks.upper && from >= *marks.upper);
    const double left = axis.place(from);
    const double width = histogram.width > 0.0 ? axis.place(to) - left : 4.0;
    // what is there is seen, however little
    const double height = std::max(1.0, kHeight * static_cast<double>(histogram.counts[i]) / most);
    content += svg::rectangle(left, kTop + kHeight - height, std::max(width - 0.5, 0.5), height,
                              std::string("fill:") + (outside ? kLimitColor : "var(--bar)"));
  }
  return content;
}

std::string normalCurve(const HistogramMarks& marks, const Axis& axis, double peak, double most) {
  constexpr int kSteps = 120;
  std::string points;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = axis.low() + (axis.high() - axis.low()) * i / kSteps;
    const double z = (value - marks.mean) / marks.sigma;
    const double height = kHeight * peak * std::exp(-0.5 * z * z) / most;
    points += svg::pixels(axis.place(value)) + "," + svg::pixels(kTop + kHeight - height) + " ";
  }
  return "<polyline points=\"" + points + "\" style=\"fill:none;stroke:var(--ink);stroke-width:1.2\"/>\n";
}

}  // namespace

std::string histogramChart(const Histogram& histogram, const HistogramMarks& marks) {
  const Axis axis(histogram, marks);
  const double width = kPlot + 2.0 * kSide, base = kTop + kHeight;
  std::string content = svg::line(kSide, base, kSide + kPlot, base, "stroke:var(--ink)");
  if (!histogram.counts.empty()) {
    const bool curve = marks.sigma > 0.0 && histogram.width > 0.0;
    const auto count = static_cast<double>(
        std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}));
    const double peak = curve ? count * histogram.width / (marks.sigma * std::sqrt(2.0 * M_PI)) : 0.0;
    const double most = std::max(
        peak, static_cast<double>(*std::max_element(histogram.counts.begin(), histogram.counts.end())));
    content += bars(histogram, marks, axis, most);
    if (curve) content += normalCurve(marks, axis, peak, most);
  }
  const auto mark = [&](double value, const std::string& style) {
    if (!axis.shows(value)) return;
    content += svg::line(axis.place(value), kTop, axis.place(value), base, style);
  };
  mark(marks.mean, "stroke:var(--ink)");
  mark(marks.nominal, "stroke:var(--ink);stroke-dasharray:2 3");
  for (const std::optional<double>& limit : {marks.lower, marks.upper}) {
    if (!limit || !axis.shows(*limit)) continue;
    mark(*limit, std::string("stroke:") + kLimitColor + ";stroke-dasharray:5 3");
    content += svg::text(axis.place(*limit), kTop - 6.0, "middle", figure(*limit));
  }
  content += svg::text(kSide, base + 16.0, "middle", figure(axis.low()));
  content += svg::text(kSide + kPlot, base + 16.0, "middle", figure(axis.high()));
  return svg::element(width, base + kBottom, content);
}

}  // namespace cable_variation
