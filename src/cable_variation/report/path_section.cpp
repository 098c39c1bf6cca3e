#include <cable_variation/report/path_section.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/profile_chart.h>
#include <cable_variation/report/verdict_table.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMillimetres = 1e3;
constexpr double kRadii =
    5.0;  // so many times the smallest bend radius are shown: a straight cable has no end
constexpr std::size_t kMostLines = 2;  // of one chart: as many colours as there are

std::string lineStyle(std::size_t index) {
  return index == 0 ? "stroke:var(--line-1)" : "stroke:var(--line-2)";
}

double placeOf(const PathFindings& found, double time, double length) {
  return found.over_time ? time : kMillimetres * length;
}

ProfileChart chartOf(const PathFindings& found, const std::string& y_title) {
  ProfileChart chart;
  chart.x_title = found.over_time ? "time [s]" : "way [mm]";
  chart.y_title = y_title;
  for (const TimedEvent& each : found.check.events) {
    if (each.event.kind != ShapeEvent::Kind::snapped) continue;
    chart.marks.emplace_back(placeOf(found, each.time, each.length), "snap");
  }
  return chart;
}

/// @param value asked of samples that are solved alone
ProfileLine lineOf(const PathFindings& found, const std::string& label, std::size_t index,
                   const std::function<double(const PathSample&)>& value) {
  ProfileLine line{label, lineStyle(index), {}};
  for (const PathSample& sample : found.check.samples) {
    line.points.emplace_back(placeOf(found, sample.time, sample.length),
                             sample.solved ? value(sample) : kNaN);
  }
  return line;
}

ReportTable eventTable(const PathCheck& check) {
  ReportTable table{"What happens on the way", {"event", "time\n[s]", "way\n[mm]", "what"}, {}};
  for (const TimedEvent& each : check.events) {
    table.rows.push_back({{shortText(each.event), 0.0, isFault(each.event.kind)},
                          plain(figure(each.time)),
                          plain(millimetres(each.length)),
                          plain(each.event.text)});
  }
  return table;
}

ReportTable measureTable(const Scene& scene, const PathCheck& check) {
  ReportTable table{"Measures along the path",
                    {"measure", "unit", "at the start", "worst", "at time\n[s]", "smallest", "largest"},
                    {}};
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    const Measure& measure = scene.measures[i];
    const DisplayUnit unit = displayUnit(measure.unit);
    const PathWorst worst = worstAlong(check, measure, i);
    const PathSample& first = check.samples.front();
    const double start = first.solved ? first.measures[i].value : kNaN;
    table.rows.push_back({plain(measure.name),
                          plain(unit.symbol),
                          plain(figure(unit.factor * withoutRounding(start, measure.unit))),
                          {figure(unit.factor * withoutRounding(worst.worst, measure.unit)), 0.0,
                           beyondLimits(measure, worst.worst)},
                          plain(figure(worst.time)),
                          plain(figure(unit.factor * withoutRounding(worst.smallest, measure.unit))),
                          plain(figure(unit.factor * withoutRounding(worst.largest, measure.unit)))});
  }
  return table;
}

ReportTable clipTable(const Scene& scene, const PathCheck& check) {
  ReportTable table{"The largest that clips bear",
                    {"clip", "cable", "force\n[N]", "at time\n[s]", "moment\n[N m]", "at time\n[s]"},
                    {}};
  for (std::size_t i = 0; i < scene.harness.clips.size(); ++i) {
    const Clip& clip = scene.harness.clips[i];
    const LargestReaction largest = largestReaction(check, i);
    table.rows.push_back({plain(clip.name), plain(scene.harness.cables[clip.cable].name),
                          plain(figure(largest.force)), plain(figure(largest.force_time)),
                          plain(figure(largest.moment)), plain(figure(largest.moment_time))});
  }
  return table;
}

void addMeasureCharts(const Scene& scene, const PathFindings& found, ReportSection& section) {
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    const Measure& measure = scene.measures[i];
    const DisplayUnit unit = displayUnit(measure.unit);
    ProfileChart chart = chartOf(found, measure.name + " [" + unit.symbol + "]");
    chart.lines = {lineOf(found, "", 0,
                          [&](const PathSample& sample) { return unit.factor * sample.measures[i].value; })};
    for (const auto& [limit, name] :
         {std::pair(measure.lower, "lower limit"), std::pair(measure.upper, "upper limit")}) {
      if (limit) chart.limits.emplace_back(unit.factor * *limit, name);
    }
    double smallest = 0.0;
    for (const auto& point : chart.lines.front().points) {
      if (std::isfinite(point.second)) smallest = std::min(smallest, point.second);
    }
    chart.least = smallest;
    section.chart(profileChart(chart), measure.name, ReportSection::Width::half);
  }
}

void addClipCharts(const Scene& scene, const PathFindings& found, ReportSection& section) {
  const std::vector<Clip>& clips = scene.harness.clips;
  for (std::size_t first = 0; first < clips.size(); first += kMostLines) {
    ProfileChart chart = chartOf(found, "force [N]");
    std::string caption = "Force on the cable at ";
    for (std::size_t i = first; i < std::min(first + kMostLines, clips.size()); ++i) {
      chart.lines.push_back(lineOf(found, clips[i].name, i - first, [i](const PathSample& sample) {
        return sample.reactions[i].force.norm();
      }));
      caption += (i == first ? "" : " and ") + clips[i].name;
    }
    section.chart(profileChart(chart), caption, ReportSection::Width::half);
  }
}

void addBendCharts(const Scene& scene, const PathFindings& found, ReportSection& section) {
  for (std::size_t i = 0; i < scene.harness.cables.size(); ++i) {
    ProfileChart chart = chartOf(found, "bend radius [mm]");
    chart.lines = {lineOf(found, "", 0,
                          [i](const PathSample& sample) { return kMillimetres * sample.bends[i].radius; })};
    const double smallest = kMillimetres * tightestBend(found.check, i).radius;
    chart.most = std::isfinite(smallest) ? kRadii * smallest : 0.0;
    section.chart(profileChart(chart), scene.harness.cables[i].name + ": smallest bend radius",
                  ReportSection::Width::half);
  }
}

}  // namespace

std::vector<std::string> pathFaults(const PathCheck& check) {
  std::size_t snaps = 0, refused = 0;
  for (const TimedEvent& each : check.events) {
    snaps += each.event.kind == ShapeEvent::Kind::snapped ? 1U : 0U;
    refused += each.event.kind == ShapeEvent::Kind::clip_refused ? 1U : 0U;
  }
  const auto lost = std::count_if(check.samples.begin(), check.samples.end(),
                                  [](const PathSample& sample) { return !sample.solved; });
  std::vector<std::string> faults;
  if (snaps > 0) faults.push_back(std::to_string(snaps) + (snaps == 1 ? " snap" : " snaps"));
  if (lost > 0) faults.push_back("no equilibrium at " + countText(lost, "place"));
  if (refused > 0) faults.emplace_back("a clip that could not close or open");
  return faults;
}

ReportSection pathSection(const Scene& scene, const PathFindings& found) {
  const PathCheck& check = found.check;
  ReportSection section("Along the path");
  const PathSample &first = check.samples.front(), &last = check.samples.back();
  section.banner(
      check.kept ? Tone::good : Tone::bad, check.kept ? "KEPT" : "NOT KEPT",
      check.kept
          ? "wherever it was looked at there is an equilibrium that keeps all limits, and nothing snaps"
          : "see what happens on the way");
  section.paragraph("Looked at " + std::to_string(check.samples.size()) + " times from " +
                    figure(first.time) + " s to " + figure(last.time) + " s, over a way of " +
                    millimetres(last.length) + " mm; the shape is followed from each to the next one.");
  if (!check.events.empty()) section.table(eventTable(check));
  if (!scene.measures.empty()) section.table(measureTable(scene, check));
  section.table(clipTable(scene, check));
  section.heading("Over the way");
  section.paragraph(
      "Dotted: snaps; dashed red: limits. Where there is no equilibrium lines are interrupted.");
  addMeasureCharts(scene, found, section);
  addClipCharts(scene, found, section);
  addBendCharts(scene, found, section);
  ProfileChart eigenvalue = chartOf(found, "smallest eigenvalue [N/m]");
  eigenvalue.lines = {
      lineOf(found, "", 0, [](const PathSample& sample) { return sample.smallest_eigenvalue; })};
  section.chart(
      profileChart(eigenvalue),
      "Smallest eigenvalue: how stiffly the shape that gives way most easily is held; it falls to 0 "
      "before a snap",
      ReportSection::Width::half);
  return section;
}

}  // namespace cable_variation
