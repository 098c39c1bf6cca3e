#include <cable_variation/report/chart.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/svg.h>

namespace cable_variation {

namespace {

/// Told apart with every colour vision (Okabe and Ito 2008).
constexpr std::array<const char*, 7> kLineColors = {"#0072b2", "#e69f00", "#009e73",   "#cc79a7",
                                                    "#56b4e9", "#d55e00", "var(--ink)"};

/// Labels are at least `gap` apart, in their order, and as near their places as that allows going down, then
/// up.
std::vector<double> spread(std::vector<double> places, double gap, double last) {
  for (std::size_t i = 1; i < places.size(); ++i) places[i] = std::max(places[i], places[i - 1] + gap);
  double bound = last;
  for (std::size_t i = places.size(); i-- > 0;) {
    places[i] = std::min(places[i], bound);
    bound = places[i] - gap;
  }
  return places;
}

}  // namespace

std::string barChart(const std::vector<Bar>& bars) {
  constexpr double kRow = 20.0, kLabels = 170.0, kBars = 220.0, kValues = 60.0;  // [px]
  double largest = 0.0;
  for (const Bar& bar : bars) largest = std::max(largest, bar.value);
  std::string content;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double top = kRow * static_cast<double>(i);
    const double length = largest > 0.0 ? kBars * bars[i].value / largest : 0.0;
    content += svg::text(kLabels - 6.0, top + 14.0, "end", bars[i].label);
    content += svg::rectangle(kLabels, top + 3.0, length, 14.0, "fill:var(--accent)");
    content += svg::text(kLabels + length + 5.0, top + 14.0, "start", bars[i].text);
  }
  return svg::element(kLabels + kBars + kValues, kRow * static_cast<double>(bars.size()), content);
}

std::string lowHighChart(double nominal, const std::vector<LowHighLine>& lines,
                         const std::optional<double>& lower, const std::optional<double>& upper) {
  constexpr double kLeft = 60.0, kPlot = 180.0, kRight = 180.0, kTop = 10.0, kBottom = 22.0;  // [px]
  constexpr double kGap = 14.0;                                                               // [px]
  const double plot_height = std::max(150.0, kGap * static_cast<double>(lines.size()));

  double smallest = nominal, largest = nominal;
  for (const LowHighLine& entry : lines) {
    for (const double value : {entry.low, entry.high}) {
      if (!std::isfinite(value)) continue;
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  // A limit nearby belongs into the picture; one far off would flatten all lines.
  const double range = largest - smallest;
  for (const std::optional<double>& limit : {lower, upper}) {
    if (!limit || *limit < smallest - range || *limit > largest + range) continue;
    smallest = std::min(smallest, *limit);
    largest = std::max(largest, *limit);
  }
  const double span = largest > smallest ? largest - smallest : 1.0;
  const auto height = [&](double value) { return kTop + plot_height * (largest - value) / span; };

  const double low_x = kLeft, nominal_x = kLeft + 0.5 * kPlot, high_x = kLeft + kPlot;
  std::string content;
  for (const double x : {low_x, nominal_x, high_x}) {
    content += svg::line(x, kTop, x, kTop + plot_height, "stroke:var(--rule)");
  }
  for (const std::optional<double>& limit : {lower, upper}) {
    if (limit && *limit >= smallest && *limit <= largest) {
      content +=
          svg::line(low_x, height(*limit), high_x, height(*limit), "stroke:var(--bad);stroke-dasharray:5 3");
    }
  }
  content += svg::text(kLeft - 6.0, height(largest) + 4.0, "end", figure(largest, 3));
  if (largest > smallest)
    content += svg::text(kLeft - 6.0, height(smallest) + 4.0, "end", figure(smallest, 3));
  const double bottom = kTop + plot_height + 16.0;
  content += svg::text(low_x, bottom, "middle", "low");
  content += svg::text(nominal_x, bottom, "middle", "nominal");
  content += svg::text(high_x, bottom, "middle", "high");

  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < lines.size(); ++i) order.push_back(i);
  const auto end = [&](std::size_t i) { return std::isfinite(lines[i].high) ? lines[i].high : nominal; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return end(a) > end(b); });
  std::vector<double> places;
  places.reserve(order.size());
  for (const std::size_t i : order) places.push_back(height(end(i)));
  places = spread(places, kGap, kTop + plot_height);

  for (std::size_t k = 0; k < order.size(); ++k) {
    const LowHighLine& entry = lines[order[k]];
    const std::string color = kLineColors[order[k] % kLineColors.size()];
    const std::string style = "stroke:" + color + ";stroke-width:1.5";
    if (std::isfinite(entry.low)) {
      content += svg::line(low_x, height(entry.low), nominal_x, height(nominal), style);
    }
    if (std::isfinite(entry.high)) {
      content += svg::line(nominal_x, height(nominal), high_x, height(entry.high), style);
    }
    content += svg::line(high_x, height(end(order[k])), high_x + 14.0, places[k],
                         "stroke:" + color + ";stroke-width:1.5");
    content += svg::text(high_x + 17.0, places[k] + 4.0, "start", entry.label);
  }
  return svg::element(kLeft + kPlot + kRight, kTop + plot_height + kBottom, content);
}

}  // namespace cable_variation
