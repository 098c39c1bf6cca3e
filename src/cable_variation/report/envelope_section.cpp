#include <cable_variation/report/envelope_section.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/envelope/clearance/clearance_limit.h>
#include <cable_variation/report/deviation_text.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/share_text.h>
#include <cable_variation/report/verdict_table.h>

namespace cable_variation {

namespace {

/// A bound of a share, rounded up to two digits.
std::string boundText(double share) {
  if (!(share > 0.0 && share < 1.0)) return percent(share);
  const double digit = std::pow(10.0, std::floor(std::log10(100.0 * share)) - 1.0);
  return figure(std::ceil(100.0 * share / digit - 1e-9) * digit, 2) + " %";
}

std::string pairText(const Scene& scene, const EnvelopeClearance& clearance) {
  const std::string other =
      clearance.other ? scene.harness.cables[*clearance.other].name : clearance.component;
  return scene.harness.cables[clearance.cable].name + " – " + other;
}

std::vector<std::size_t> closestFirst(const std::vector<EnvelopeClearance>& clearances) {
  std::vector<std::size_t> order(clearances.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return clearances[a].distance < clearances[b].distance;
  });
  return order;
}

const char* kindText(EnvelopeClearance::Kind kind) {
  switch (kind) {
    case EnvelopeClearance::Kind::together:
      return "both cables in one harness at one time";
    case EnvelopeClearance::Kind::production:
      return "harnesses as they are produced";
    case EnvelopeClearance::Kind::bodies:
      break;
  }
  return "a bound for all shapes in the envelope";
}

ReportTable closestTable(const Scene& scene, const EnvelopeFindings& found) {
  constexpr std::size_t kMost = 10;
  ReportTable table{
      "With which deviations they come closest, of those solved", {"clearance", "deviations", "note"}, {}};
  const std::vector<std::size_t> order = closestFirst(found.clearances);
  for (std::size_t k = 0; k < std::min(kMost, order.size()); ++k) {
    const EnvelopeClearance& each = found.clearances[order[k]];
    table.rows.push_back({plain(pairText(scene, each)),
                          plain(deviationText(scene, found.envelope.variables, each.deviations)),
                          plain(noteOf(each))});
  }
  return table;
}

ReportTable snapTable(const Scene& scene, const EnvelopeFindings& found) {
  ReportTable table{
      "Snaps: the cables jump to another equilibrium. Of each pair of equilibria the jump nearest to the "
      "design, at a share of the tolerances; how many random shapes lie beyond, and of all less than, "
      "with 95 % confidence",
      {"cable", "jump\n[mm]", "at arc length\n[mm]", "time\n[s]", "at a share\nof tolerances", "beyond it",
       "less than", "just beyond it"},
      {}};
  for (const Snap& snap : found.envelope.snaps) {
    table.rows.push_back({plain(scene.harness.cables[snap.cable].name), plain(millimetres(snap.jump)),
                          plain(millimetres(snap.arc_length)), plain(figure(snap.time)),
                          plain(percent(snap.begins)), plain(percent(snap.share)),
                          plain(boundText(snap.share_bound)),
                          plain(deviationText(scene, found.envelope.variables, snap.after))});
  }
  return table;
}

}  // namespace

std::string containmentText(const Envelope& envelope) {
  const Containment& found = envelope.containment;
  if (found.shapes == 0) return "not looked at";
  if (envelope.probability > 0.0) {
    const auto missed = static_cast<double>(found.outside + found.failed);
    return shareText(1.0 - missed / static_cast<double>(found.shapes)) + " held of " +
           std::to_string(found.shapes) +
           " fresh harnesses of production; of all, with 95 % confidence, all but " +
           boundText(found.outside_bound) + " at most";
  }
  std::string text = std::to_string(found.outside) + " outside of " + std::to_string(found.shapes) +
                     " independent random shapes";
  if (found.outside > 0) text += ", by up to " + millimetres(found.largest_excess) + " mm";
  return text + "; of all, with 95 % confidence, less than " + boundText(found.outside_bound);
}

ReportTable envelopeTable(const EnvelopeFindings& found) {
  const Envelope& envelope = found.envelope;
  ReportTable table{"The envelope", {"figure", "value", "unit", "what it is"}, {}};
  const auto add = [&](const char* name, const std::string& value, const char* unit,
                       const std::string& what) {
    table.rows.push_back({plain(name), plain(value), plain(unit), {what, 0.0, false}});
  };
  add("volume", figure(1e6 * found.volume), "cm³",
      "within its surface, which is at most " + millimetres(found.surface_excess, 2) + " mm outside of it");
  add("inflation", millimetres(envelope.inflation), "mm",
      "of every piece; " + millimetres(envelope.largest_inflation) +
          " mm at most in those of rare shapes, near snaps");
  if (!found.options.motions.empty()) {
    add("motion", millimetres(envelope.motion_excess), "mm",
        "at most, about, spanned by the pieces of " + std::to_string(envelope.phases.size()) +
            " phases beyond the ways of the clips");
  }
  if (envelope.tightness.shapes > 0) {
    add("tightness", figure(envelope.tightness.ratio()), "",
        "times the volume of " + std::to_string(envelope.tightness.shapes) +
            " random shapes together, in voxels of " + millimetres(envelope.tightness.voxel) + " mm");
  }
  add("shapes", std::to_string(envelope.samples.size()), "",
      "that its hulls are made of: the design, those that stand out of the " +
          std::to_string(envelope.solves) + " solved to look for them, and of the random ones; " +
          "centrelines within about " + millimetres(envelope.discretisation_error, 2) +
          " mm of the exact ones");
  return table;
}

ReportTable clearanceTable(const Scene& scene, const EnvelopeFindings& found) {
  const bool in_motion = !found.options.motions.empty();
  ReportTable table{"Clearances of the envelope, the closest first; below 0 they overlap",
                    {"clearance", "verdict", "envelope\n[mm]", "closest solved\n[mm]", "design\n[mm]",
                     "limit\n[mm]", "at arc length\n[mm]", "at x, y, z\n[mm]"},
                    {}};
  if (in_motion) table.columns.emplace_back("at time\n[s]");
  table.columns.emplace_back("figure of");
  for (const std::size_t i : closestFirst(found.clearances)) {
    const EnvelopeClearance& each = found.clearances[i];
    const std::optional<double> limit = lowerLimit(scene, each);
    const double least = std::max(limit.value_or(0.0), 0.0);
    const auto distance = [&](double value) { return ReportCell{millimetres(value), 0.0, value < least}; };
    const Eigen::Vector3d& at = each.on_envelope;
    std::vector<ReportCell> row{
        plain(pairText(scene, each)),
        verdictCell(verdictOf(scene, each)),
        distance(each.distance),
        distance(each.worst_sample),
        distance(each.nominal),
        plain(limit ? millimetres(*limit) : ""),
        plain(millimetres(each.arc_length, 3)),
        plain(millimetres(at.x()) + ", " + millimetres(at.y()) + ", " + millimetres(at.z()))};
    if (in_motion) row.push_back(plain(figure(each.time)));
    row.push_back(plain(kindText(each.kind)));
    table.rows.push_back(row);
  }
  return table;
}

ReportSection envelopeSection(const Scene& scene, const EnvelopeFindings& found) {
  const Envelope& envelope = found.envelope;
  ReportSection section("Envelope");
  section.paragraph(envelope.probability > 0.0
                        ? "The space that the cables take up in " + shareText(envelope.probability) +
                              " of production."
                        : "The space that the cables take up with anything that the tolerances allow.");
  section.paragraph("Containment: " + containmentText(envelope) + ".");
  if (envelope.failures > 0 || envelope.containment.failed > 0) {
    section.warning(std::to_string(envelope.failures) + " equilibria asked for do not exist, and " +
                    std::to_string(envelope.containment.failed) +
                    " of the independent shapes: the envelope knows nothing of these.");
  }
  section.table(envelopeTable(found));
  if (!found.clearances.empty()) {
    section.heading("Clearances");
    section.table(clearanceTable(scene, found));
    section.paragraph(
        "Envelope: what can come no closer, as far as the envelope holds all shapes; closest solved: a "
        "harness that "
        "does come so close. They fail where a harness solved breaks the limit, and are marginal where only "
        "the "
        "envelope does.");
    section.table(closestTable(scene, found));
  }
  if (!envelope.snaps.empty()) {
    section.heading("Snaps");
    section.table(snapTable(scene, found));
  }
  return section;
}

}  // namespace cable_variation
