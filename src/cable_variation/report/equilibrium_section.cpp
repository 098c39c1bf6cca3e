#include <cable_variation/report/equilibrium_section.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/equilibrium/bend_radius.h>
#include <cable_variation/report/cable_profile.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/route_table.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

ReportTable shapeTable(const SolvedScene& solved) {
  ReportTable table{"Cables",
                    {"cable", "length\n[mm]", "radius\n[mm]", "mass\n[g]", "smallest bend\nradius [mm]",
                     "at arc length\n[mm]", "lowest z\n[mm]"},
                    {}};
  for (std::size_t i = 0; i < solved.harness.cables.size(); ++i) {
    const Cable& cable = solved.harness.cables[i];
    const CableShape& shape = solved.equilibrium.shapes[i];
    const BendRadius bend = smallestBendRadius(shape);
    double lowest = std::numeric_limits<double>::infinity();
    for (const ShapePoint& point : shape.points) lowest = std::min(lowest, point.pose.position.z());
    table.rows.push_back({plain(cable.name), plain(millimetres(cable.length)),
                          plain(millimetres(shape.radius)), plain(figure(1e3 * massOf(cable))),
                          plain(millimetres(bend.radius)), plain(millimetres(bend.arc_length)),
                          plain(millimetres(lowest))});
  }
  return table;
}

void addReaction(const Reaction& reaction, const std::string& type, const std::string& cable,
                 ReportTable& table) {
  constexpr int kDigits = 4;
  std::vector<ReportCell> row{plain(reaction.name), plain(type), plain(cable),
                              plain(millimetres(reaction.arc_length))};
  const auto add = [&](const Eigen::Vector3d& of, const char* unit) {
    for (int k = 0; k < 3; ++k) row.push_back(plain(figure(withoutRounding(of[k], unit), kDigits)));
    row.push_back(plain(figure(withoutRounding(of.norm(), unit), kDigits)));
  };
  add(reaction.force, "N");
  add(reaction.moment, "N m");
  table.rows.push_back(row);
}

ReportTable reactionTable(const SolvedScene& solved) {
  ReportTable table{
      "What clips do to their cables, and joints to the child: along the axes of the world, moments "
      "about the section held",
      {"reaction of", "type", "cable", "at arc length\n[mm]", "Fx\n[N]", "Fy\n[N]", "Fz\n[N]", "|F|\n[N]",
       "Mx\n[N m]", "My\n[N m]", "Mz\n[N m]", "|M|\n[N m]"},
      {}};
  const Harness& harness = solved.harness;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    addReaction(solved.equilibrium.clip_reactions[i], harness.clips[i].type,
                harness.cables[harness.clips[i].cable].name, table);
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    addReaction(solved.equilibrium.joint_reactions[i], "joint", harness.cables[harness.joints[i].child].name,
                table);
  }
  return table;
}

ReportTable contactTable(const SolvedScene& solved) {
  constexpr int kDigits = 4;
  ReportTable table{"Where parts press cables: forces on the cable along the axes of the world",
                    {"part", "cable", "from arc length\n[mm]", "to\n[mm]", "Fx\n[N]", "Fy\n[N]", "Fz\n[N]",
                     "sum of amounts\n[N]"},
                    {}};
  for (const ContactInterval& interval : solved.equilibrium.contacts) {
    std::vector<ReportCell> row{plain(interval.part), plain(solved.harness.cables[interval.cable].name),
                                plain(millimetres(interval.start)), plain(millimetres(interval.end))};
    for (int k = 0; k < 3; ++k) row.push_back(plain(figure(interval.force[k], kDigits)));
    row.push_back(plain(figure(interval.total, kDigits)));
    table.rows.push_back(row);
  }
  return table;
}

std::string stabilityOf(const Equilibrium& equilibrium) {
  if (std::isnan(equilibrium.smallest_eigenvalue))
    return "Stable; the smallest eigenvalue is not yet known where cables touch parts.";
  return "Stable: smallest eigenvalue " + figure(equilibrium.smallest_eigenvalue) + " N/m.";
}

}  // namespace

std::vector<ReportTable> equilibriumTables(const SolvedScene& solved) {
  std::vector<ReportTable> tables{shapeTable(solved), reactionTable(solved)};
  if (!solved.equilibrium.contacts.empty()) tables.push_back(contactTable(solved));
  return tables;
}

ReportSection equilibriumSection(const Scene& scene, const SolvedScene& solved,
                                 const std::vector<std::size_t>& measures,
                                 const std::vector<MeasureValue>& values) {
  const Equilibrium& equilibrium = solved.equilibrium;
  ReportSection section("The design at rest");
  section.paragraph(stabilityOf(equilibrium) + " Forces are balanced to " + figure(equilibrium.residual, 2) +
                    " N; centrelines are within about " + millimetres(equilibrium.discretisation_error, 2) +
                    " mm of the exact ones. Elastic energy " +
                    figure(withoutRounding(equilibrium.energy.elastic, "J")) +
                    " J. Other stable shapes met: " + std::to_string(equilibrium.alternatives.size()) + ".");
  for (const std::string& note : equilibrium.notes) section.warning(note);
  const ReportTable routes = routeTable(scene, measures, values);
  if (!routes.rows.empty()) section.table(routes);
  for (const ReportTable& table : equilibriumTables(solved)) section.table(table);
  section.heading("Along the cables");
  section.paragraph(
      "From the start of each cable to its end; dotted: clips and joints, where forces and moments may jump; "
      "dashed "
      "red: limits of measures.");
  for (std::size_t i = 0; i < solved.harness.cables.size(); ++i) {
    if (touchesPart(equilibrium, i)) {
      section.paragraph("Cable " + solved.harness.cables[i].name +
                        " touches a part: its section forces and moments between the sections solved are not "
                        "yet known, and not drawn.");
    }
    for (const auto& [chart, caption] : profileCharts(scene, solved, i))
      section.chart(chart, caption, ReportSection::Width::half);
  }
  return section;
}

}  // namespace cable_variation
