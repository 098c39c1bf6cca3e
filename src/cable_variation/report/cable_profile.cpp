#include <cable_variation/report/cable_profile.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/measures/section_loads.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/profile_chart.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

constexpr int kSteps = 4;  // between two sections solved
constexpr double kRadii =
    5.0;  // so many times the smallest bend radius are shown: a straight cable has no end
constexpr const char* kFirst = "stroke:var(--line-1)";
constexpr const char* kSecond = "stroke:var(--line-2)";

double inMillimetres(double metres) { return displayUnit("m").factor * metres; }

ProfileLine lineOf(const std::vector<ProfilePoint>& profile, const std::string& label, const char* style,
                   double (*value)(const ProfilePoint&)) {
  ProfileLine line{label, style, {}};
  for (const ProfilePoint& point : profile)
    line.points.emplace_back(inMillimetres(point.arc_length), value(point));
  return line;
}

/// Limits of the measures of a type that look at all of the cable, not at one section or along one axis.
std::vector<std::pair<double, std::string>> limitsOf(const Scene& scene, std::size_t cable,
                                                     Measure::Type type) {
  std::vector<std::pair<double, std::string>> limits;
  for (const Measure& measure : scene.measures) {
    const auto& of = measure.cables;
    if (measure.type != type || measure.arc_length || measure.axis) continue;
    if (std::find(of.begin(), of.end(), cable) == of.end()) continue;
    for (const auto& limit : {measure.lower, measure.upper}) {
      if (limit) limits.emplace_back(*limit, measure.name);
    }
  }
  return limits;
}

ProfileChart chartOf(const SolvedScene& solved, std::size_t cable, const std::string& y_title) {
  ProfileChart chart;
  chart.x_title = "arc length [mm]";
  chart.y_title = y_title;
  for (std::size_t i = 0; i < solved.harness.clips.size(); ++i) {
    if (solved.harness.clips[i].cable != cable) continue;
    const Reaction& held = solved.equilibrium.clip_reactions[i];
    chart.marks.emplace_back(inMillimetres(held.arc_length), held.name);
  }
  for (const Joint& joint : solved.harness.joints) {
    if (joint.parent == cable) chart.marks.emplace_back(inMillimetres(joint.parent_arc_length), joint.name);
    if (joint.child == cable) chart.marks.emplace_back(inMillimetres(joint.child_arc_length), joint.name);
  }
  std::sort(chart.marks.begin(), chart.marks.end());
  return chart;
}

}  // namespace

std::vector<ProfilePoint> cableProfile(const SolvedScene& solved, std::size_t cable) {
  const CableView view(solved.harness.cables[cable], solved.equilibrium.shapes[cable]);
  std::vector<ProfilePoint> profile;
  for (std::size_t i = 0; i < view.pieces().size(); ++i) {
    const CableView::Piece& piece = view.pieces()[i];
    const SectionLoads loads(view, i, solved.harness.gravity);
    const CurvePiece curve = curveBetween(view.start(i), view.end(i));
    const bool after_jump = i == 0 || view.pieces()[i - 1].point + 1 != piece.point;
    for (int k = after_jump ? 0 : 1; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      const Vector3d force = loads.force(t), moment = loads.moment(t);
      profile.push_back({view.start(i).arc_length + t * piece.length, force.norm(), force.x(), moment.norm(),
                         moment.x(), curve.curvature(t)});
    }
  }
  return profile;
}

bool touchesPart(const Equilibrium& equilibrium, std::size_t cable) {
  return std::any_of(equilibrium.contacts.begin(), equilibrium.contacts.end(),
                     [&](const ContactInterval& interval) { return interval.cable == cable; });
}

namespace {

void addLoadCharts(const std::vector<ProfilePoint>& profile, const Scene& scene, const SolvedScene& solved,
                   std::size_t cable, std::vector<std::pair<std::string, std::string>>& charts) {
  const std::string& name = solved.harness.cables[cable].name;
  ProfileChart force = chartOf(solved, cable, "force [N]");
  force.lines = {lineOf(profile, "all of it", kFirst, [](const ProfilePoint& p) { return p.force; }),
                 lineOf(profile, "tension", kSecond, [](const ProfilePoint& p) { return p.axial; })};
  force.limits = limitsOf(scene, cable, Measure::Type::section_force);
  charts.emplace_back(profileChart(force),
                      name + ": section force, and its part along the cable, tension positive");

  ProfileChart moment = chartOf(solved, cable, "moment [N m]");
  moment.lines = {lineOf(profile, "all of it", kFirst, [](const ProfilePoint& p) { return p.moment; }),
                  lineOf(profile, "torsion", kSecond, [](const ProfilePoint& p) { return p.torsion; })};
  moment.limits = limitsOf(scene, cable, Measure::Type::section_moment);
  charts.emplace_back(profileChart(moment), name + ": section moment, and its part about the cable");
}

}  // namespace

std::vector<std::pair<std::string, std::string>> profileCharts(const Scene& scene, const SolvedScene& solved,
                                                               std::size_t cable) {
  const std::vector<ProfilePoint> profile = cableProfile(solved, cable);
  const std::string& name = solved.harness.cables[cable].name;
  std::vector<std::pair<std::string, std::string>> charts;

  if (!touchesPart(solved.equilibrium, cable)) addLoadCharts(profile, scene, solved, cable, charts);

  ProfileChart curvature = chartOf(solved, cable, "curvature [1/m]");
  curvature.lines = {lineOf(profile, "", kFirst, [](const ProfilePoint& p) { return p.curvature; })};
  for (const auto& [radius, measure] : limitsOf(scene, cable, Measure::Type::bend_radius)) {
    if (radius > 0.0) curvature.limits.emplace_back(1.0 / radius, measure);
  }
  charts.emplace_back(profileChart(curvature), name + ": curvature of the centreline");

  ProfileChart radius = chartOf(solved, cable, "bend radius [mm]");
  radius.lines = {
      lineOf(profile, "", kFirst, [](const ProfilePoint& p) { return inMillimetres(1.0 / p.curvature); })};
  double smallest = HUGE_VAL;
  for (const auto& point : radius.lines.front().points) smallest = std::min(smallest, point.second);
  radius.most = std::isfinite(smallest) ? kRadii * smallest : 0.0;
  for (const auto& [limit, measure] : limitsOf(scene, cable, Measure::Type::bend_radius)) {
    radius.limits.emplace_back(inMillimetres(limit), measure);
    if (radius.most > 0.0) radius.most = std::max(radius.most, 1.2 * inMillimetres(limit));
  }
  charts.emplace_back(profileChart(radius),
                      name + ": bend radius of the centreline; straight stretches are off the scale");
  return charts;
}

}  // namespace cable_variation
