#include <cable_variation/report/route_table.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/report/csv.h>
#include <cable_variation/report/markup.h>

namespace cable_variation {
namespace {

bool isRoute(const Measure& measure) { return measure.type == Measure::Type::route_deviation; }

std::string placeColumns(bool known, const Eigen::Vector3d& point) {
  const double none = std::nan("");
  std::string text;
  for (int i = 0; i < 3; ++i) text += "," + csv::number(known ? point[i] : none);
  return text;
}

}  // namespace

ReportTable routeTable(const Scene& scene, const std::vector<std::size_t>& measures,
                       const std::vector<MeasureValue>& values) {
  ReportTable table{"How far cables are from their planned routes, the largest deviation first",
                    {"measure", "segment", "cable", "from arc length\n[mm]", "to\n[mm]", "deviation\n[mm]",
                     "at most\n[mm]", "at arc length\n[mm]"},
                    {}};
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (isRoute(scene.measures[measures[i]])) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a].value > values[b].value; });
  for (const std::size_t i : order) {
    const Measure& measure = scene.measures[measures[i]];
    const MeasureValue& value = values[i];
    table.rows.push_back({plain(measure.name),
                          plain(measure.segment),
                          plain(scene.harness.cables[measure.cables.front()].name),
                          plain(millimetres(measure.from)),
                          plain(millimetres(measure.to)),
                          {millimetres(value.value), 0.0, beyondLimits(measure, value.value)},
                          plain(measure.upper ? millimetres(*measure.upper) : ""),
                          plain(value.has_place ? millimetres(value.arc_length) : "")});
  }
  return table;
}

std::string routeCsv(const Scene& scene, const std::vector<std::size_t>& measures,
                     const std::vector<MeasureValue>& values) {
  std::string text =
      "segment,measure,cable,from [m],to [m],deviation [m],lower [m],upper [m],arc length [m],x [m],y [m],z "
      "[m],"
      "route x [m],route y [m],route z [m]\r\n";
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Measure& measure = scene.measures[measures[i]];
    if (!isRoute(measure)) continue;
    const MeasureValue& value = values[i];
    text += csv::text(measure.segment) + "," + csv::text(measure.name) + "," +
            csv::text(scene.harness.cables[measure.cables.front()].name) + "," + csv::number(measure.from) +
            "," + csv::number(measure.to) + "," + csv::number(value.value) + "," +
            csv::number(measure.lower) + "," + csv::number(measure.upper) + "," +
            csv::number(value.has_place ? value.arc_length : std::nan("")) +
            placeColumns(value.has_place, value.point) + placeColumns(value.has_other, value.other) + "\r\n";
  }
  return text;
}

std::vector<std::size_t> routeMeasures(const Scene& scene) {
  std::vector<std::size_t> routes;
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    if (isRoute(scene.measures[i])) routes.push_back(i);
  }
  return routes;
}

std::vector<std::size_t> withoutPlainRoutes(const Scene& scene, const std::vector<std::size_t>& measures) {
  std::vector<std::size_t> others;
  for (const std::size_t index : measures) {
    const Measure& measure = scene.measures[index];
    if (!isRoute(measure) || measure.lower || measure.upper) others.push_back(index);
  }
  return others;
}

}  // namespace cable_variation
