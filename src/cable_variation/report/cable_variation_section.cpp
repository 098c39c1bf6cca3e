#include <cable_variation/report/cable_variation_section.h>

#include <algorithm>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/svg.h>

namespace cable_variation {

namespace {

double sixSigma(const SectionVariation& section) { return 6.0 * section.axes.sigma[0]; }
double range(const SectionVariation& section) { return section.range.maxCoeff(); }

/// 6σ and range over the arc length.
std::string alongChart(const CableVariation& cable) {
  constexpr double kLeft = 60.0, kPlot = 420.0, kRight = 70.0, kTop = 10.0, kHeight = 150.0, kBottom = 34.0;
  const double length = cable.arc_length.back();
  double largest = 0.0;
  for (const SectionVariation& section : cable.sections)
    largest = std::max({largest, sixSigma(section), range(section)});
  const auto x = [&](std::size_t i) { return kLeft + kPlot * cable.arc_length[i] / length; };
  const auto y = [&](double value) {
    return kTop + kHeight * (1.0 - (largest > 0.0 ? value / largest : 0.0));
  };
  std::string content =
      svg::line(kLeft, kTop + kHeight, kLeft + kPlot, kTop + kHeight, "stroke:var(--faint)");
  content += svg::line(kLeft, kTop, kLeft, kTop + kHeight, "stroke:var(--faint)");
  content += svg::text(kLeft - 6.0, kTop + 4.0, "end", millimetres(largest));
  content += svg::text(kLeft - 6.0, kTop + kHeight + 4.0, "end", "0");
  content += svg::text(kLeft, kTop + kHeight + 16.0, "middle", "0");
  content += svg::text(kLeft + kPlot, kTop + kHeight + 16.0, "middle", millimetres(length));
  content += svg::text(kLeft + 0.5 * kPlot, kTop + kHeight + 28.0, "middle", "arc length [mm]");
  struct Line {
    const char* label;
    double (*value)(const SectionVariation&);
    const char* style;
  };
  for (const Line& line : {Line{"6σ", sixSigma, "stroke:var(--line-1);stroke-width:1.5"},
                           Line{"range", range, "stroke:var(--line-2);stroke-width:1.5"}}) {
    std::size_t highest = 0;
    for (std::size_t i = 1; i < cable.sections.size(); ++i) {
      content += svg::line(x(i - 1), y(line.value(cable.sections[i - 1])), x(i),
                           y(line.value(cable.sections[i])), line.style);
      if (line.value(cable.sections[i]) > line.value(cable.sections[highest])) highest = i;
    }
    content += svg::text(x(highest), y(line.value(cable.sections[highest])) + 14.0, "middle", line.label);
  }
  return svg::element(kLeft + kPlot + kRight, kTop + kHeight + kBottom, content);
}

ReportTable timeTable(const Simulation& simulation) {
  ReportTable table;
  table.caption =
      "Times of the motion at which every sample was solved, and how often a measure was at its worst there";
  table.columns = {"time\n[s]", "6σ at most\n[mm]", "at its worst"};
  for (const SimulatedTime& time : simulation.times) {
    table.rows.push_back({{figure(time.time, 5), 0.0, false},
                          {millimetres(time.largest_6s), 0.0, false},
                          {std::to_string(time.worst), 0.0, false}});
  }
  return table;
}

}  // namespace

ReportTable largestVariationTable(const Scene& scene, const Simulation& simulation) {
  ReportTable table;
  table.caption = "Where each cable varies most";
  table.columns = {
      "cable", "6σ\n[mm]", "range\n[mm]", "at s\n[mm]", "mean place\nx, y, z [mm]", "direction\nx, y, z"};
  for (const CableVariation& cable : simulation.cables) {
    const auto largest = std::max_element(
        cable.sections.begin(), cable.sections.end(),
        [](const SectionVariation& a, const SectionVariation& b) { return sixSigma(a) < sixSigma(b); });
    const auto i = static_cast<std::size_t>(largest - cable.sections.begin());
    const Eigen::Vector3d direction = largest->axes.directions.col(0);
    const Eigen::Vector3d& mean = largest->mean;
    table.rows.push_back(
        {plain(scene.harness.cables[cable.cable].name), plain(millimetres(sixSigma(*largest))),
         plain(millimetres(range(*largest))), plain(millimetres(cable.arc_length[i])),
         plain(millimetres(mean.x()) + ", " + millimetres(mean.y()) + ", " + millimetres(mean.z())),
         plain(figure(direction.x(), 2) + ", " + figure(direction.y(), 2) + ", " +
               figure(direction.z(), 2))});
  }
  return table;
}

ReportSection cableVariationSection(const Scene& scene, const Simulation& simulation) {
  ReportSection section("Along the cables");
  const bool over_motion = simulation.times.size() > 1;
  if (over_motion) section.table(timeTable(simulation));
  if (simulation.statistics.count(SampleOutcome::solved) +
          simulation.statistics.count(SampleOutcome::snapped) <
      2) {
    section.paragraph("Fewer than two samples came to a shape: nothing varies.");
    return section;
  }
  if (over_motion) {
    section.paragraph("What follows is of t = " + figure(simulation.shown_time, 5) +
                      " s, where the cables vary most.");
  }
  section.table(largestVariationTable(scene, simulation));
  for (const CableVariation& cable : simulation.cables) {
    section.chart(alongChart(cable), scene.harness.cables[cable.cable].name +
                                         ": six standard deviations in the direction that varies most, and "
                                         "range, of the centreline's position [mm]");
  }
  return section;
}

}  // namespace cable_variation
