// Markers: cables true to size, clips told apart by kind, deletions of what is gone.
#include <ros_interface/display/marker_channel.h>
#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/markers/clip_markers.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/markers/contact_markers.h>
#include <ros_interface/markers/route_markers.h>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Clamped at both ends, 40 % longer than its span, thicker at its end.
Harness sagging() {
  const Material material{1e8, 0.25, 2000};
  Harness harness;
  harness.cables.resize(1);
  harness.cables[0].name = "strand";
  harness.cables[0].length = 0.28;
  harness.cables[0].sections = {{0.0, solidSection(0.003, material)}, {0.28, solidSection(0.005, material)}};
  Clip clip;
  clip.name = "A";
  clip.type = "fixed";
  clip.constraint = fixedClip();
  harness.clips.push_back(clip);
  clip.name = "B";
  clip.arc_length = 0.28;
  clip.pose.position.x() = 0.2;
  harness.clips.push_back(clip);
  return harness;
}

class CableMarkers : public testing::Test {
 protected:
  Harness harness_ = sagging();
  Equilibrium equilibrium_ = EquilibriumSolver().solve(harness_);
};

Eigen::Vector3d axisOf(const Marker& marker) {
  const auto& q = marker.pose.orientation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d::UnitX();
}

Eigen::Vector3d startOf(const Marker& marker) {
  return {marker.pose.position.x, marker.pose.position.y, marker.pose.position.z};
}

TEST_F(CableMarkers, SegmentsFollowTheCentrelineWithoutGapsAndWithItsThickness) {
  ASSERT_TRUE(equilibrium_.converged()) << equilibrium_.message;
  std::vector<Marker> segments;
  for (const Marker& marker : cableMarkers(equilibrium_, harness_).markers) {
    EXPECT_EQ(marker.ns, "cable/strand");
    EXPECT_EQ(marker.header.frame_id, "world");
    if (marker.type == Marker::MESH_RESOURCE) segments.push_back(marker);
  }
  ASSERT_GT(segments.size(), 20u);
  EXPECT_LT(segments.size(), 400u);
  EXPECT_EQ(startOf(segments.front()), equilibrium_.shapes[0].position(0.0));
  for (std::size_t i = 1; i < segments.size(); ++i) {
    const Marker& before = segments[i - 1];
    const Eigen::Vector3d end = startOf(before) + before.scale.x * axisOf(before);
    // The next one starts inside, a fraction of the radius from the end, and bends little.
    EXPECT_LT((end - startOf(segments[i])).dot(axisOf(before)), 0.3 * before.scale.y);
    EXPECT_GT((end - startOf(segments[i])).dot(axisOf(before)), 0.0);
    EXPECT_GT(axisOf(before).dot(axisOf(segments[i])), std::cos(5.0 * M_PI / 180.0));
    EXPECT_EQ(segments[i].scale.y, segments[i].scale.z);
  }
  EXPECT_NEAR(segments.front().scale.y, 0.003, 1e-4);
  EXPECT_NEAR(segments.back().scale.y, 0.005, 1e-4);
}

TEST_F(CableMarkers, NoEquilibriumNoCable) {
  equilibrium_.status = EquilibriumStatus::not_converged;
  EXPECT_TRUE(cableMarkers(equilibrium_, harness_).markers.empty());
}

TEST_F(CableMarkers, IdsAreStable) {
  const auto ids = [&] {
    std::vector<std::pair<std::string, int>> all;
    for (const Marker& marker : cableMarkers(equilibrium_, harness_).markers)
      all.emplace_back(marker.ns, marker.id);
    return all;
  };
  const auto first = ids();
  EXPECT_EQ(first, ids());
  EXPECT_EQ((std::set<std::pair<std::string, int>>(first.begin(), first.end()).size()), first.size());
}

// A stretch of 25 mm of many places, pressed evenly, is three arrows of a third of its force each; what
// presses a hundredth of that in one place is none. They point away from the part, and start beyond the
// cable.
TEST_F(CableMarkers, ForcesOfContactAreArrowsOfSomeMillimetres) {
  ASSERT_TRUE(equilibrium_.converged()) << equilibrium_.message;
  EXPECT_TRUE(contactMarkers(equilibrium_, harness_).markers.empty());
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const CableShape& shape = equilibrium_.shapes[0];
  ContactInterval flat;
  flat.start = 0.1;
  flat.end = 0.125;
  constexpr int kPlaces = 30;
  for (int i = 0; i < kPlaces; ++i) {
    const double s = flat.start + (i + 0.5) / kPlaces * (flat.end - flat.start);
    flat.places.push_back({s, shape.position(s) - shape.radius * up, up, 0.1});
    flat.total += 0.1;
  }
  ContactInterval faint;
  faint.start = faint.end = 0.2;
  faint.total = 0.01;
  faint.places = {{0.2, shape.position(0.2) - shape.radius * up, up, 0.01}};
  equilibrium_.contacts = {flat, faint};
  const std::vector<Marker> arrows = contactMarkers(equilibrium_, harness_).markers;
  ASSERT_EQ(arrows.size(), 3u);
  double last = flat.start;
  for (const Marker& arrow : arrows) {
    EXPECT_EQ(arrow.ns, "contact/strand");
    EXPECT_EQ(arrow.type, Marker::ARROW);
    ASSERT_EQ(arrow.points.size(), 2u);
    EXPECT_EQ(arrow.points[0].x, arrow.points[1].x);
    EXPECT_GT(arrow.points[1].z - arrow.points[0].z, 0.005);
    EXPECT_NEAR(arrow.points[1].z - arrow.points[0].z, arrows[0].points[1].z - arrows[0].points[0].z, 1e-12);
    const double middle = last + 0.5 * (flat.end - flat.start) / 3.0;
    last += (flat.end - flat.start) / 3.0;
    EXPECT_NEAR(arrow.points[0].x, shape.position(middle).x(), 1e-4);
    EXPECT_NEAR(arrow.points[0].z, shape.position(middle).z() + shape.radius, 1e-3);
  }
  const std::vector<Label> labels = contactLabels(equilibrium_);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "3 N");
  EXPECT_EQ(labels[1].text, "0.01 N");
}

// Routes run from point to point in the colour of their deviation, the largest in viridis' last; the largest
// and those beyond their limit are labelled.
TEST(RouteMarkers, AreLinesInTheColourOfTheirDeviation) {
  Scene scene;
  std::vector<MeasureValue> values(4);
  const char* names[] = {"near", "far", "else", "unknown"};
  for (std::size_t i = 0; i < 4; ++i) {
    Measure measure;
    measure.name = names[i];
    measure.type = i == 2 ? Measure::Type::energy : Measure::Type::route_deviation;
    measure.route = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0.1, 0}};
    scene.measures.push_back(measure);
    values[i].value = i == 3 ? std::nan("") : 0.01 * static_cast<double>(i);
    values[i].has_other = i < 2;
    values[i].point = {0.1, 0.0, 0.01 * static_cast<double>(i)};
    values[i].other = {0.1, 0.0, 0.0};
  }
  scene.measures[0].upper = -1.0;  // beyond it, whatever it is
  const std::vector<Marker> markers = routeMarkers(scene, values).markers;
  ASSERT_EQ(markers.size(), 5u);  // two routes with where they are furthest, one without
  EXPECT_EQ(markers[0].ns, "route/near");
  EXPECT_EQ(markers[2].ns, "route/far");
  EXPECT_EQ(markers[4].ns, "route/unknown");
  for (const std::size_t route : {0u, 2u, 4u}) {
    EXPECT_EQ(markers[route].type, Marker::LINE_LIST);
    ASSERT_EQ(markers[route].points.size(), 4u);
    EXPECT_EQ(markers[route].points[3].y, 0.1);
  }
  EXPECT_EQ(markers[3].points[0].z, 0.01);
  const auto hasColour = [&](const Marker& marker, const Eigen::Vector3d& colour) {
    return (Eigen::Vector3d(marker.color.r, marker.color.g, marker.color.b) - colour).norm() < 1e-5;
  };
  EXPECT_TRUE(hasColour(markers[0], viridis(0.0)));
  EXPECT_TRUE(hasColour(markers[2], viridis(1.0)));
  EXPECT_TRUE(hasColour(markers[4], viridis(std::nan(""))));
  const std::vector<Label> labels = routeLabels(scene, values);
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].kind, Label::FAULT);
  EXPECT_EQ(labels[1].kind, Label::FIGURE);
  EXPECT_EQ(labels[1].text, "far 10 mm");
  EXPECT_EQ(routeMarkers(scene, {}).markers.size(), 3u);  // without an equilibrium all are grey
}

/// Types and sizes of a clip's markers.
std::string lookOf(const std::string& type, const ClipConstraint& constraint) {
  Harness harness = sagging();
  harness.clips.resize(1);
  harness.clips[0].type = type;
  harness.clips[0].constraint = constraint;
  Equilibrium equilibrium;
  equilibrium.status = EquilibriumStatus::converged;
  equilibrium.clip_reactions.resize(1);
  std::ostringstream look;
  for (const Marker& marker : clipMarkers(equilibrium, harness).markers) {
    EXPECT_EQ(marker.ns, "clip/A");
    if (marker.type != Marker::TEXT_VIEW_FACING) {
      look << marker.type << ' ' << marker.scale << marker.points.size() << ' ' << marker.pose << '\n';
      EXPECT_LT(marker.color.r, 0.5f + std::max(marker.color.g, marker.color.b)) << "red is for interference";
    } else {
      EXPECT_EQ(marker.text, "A");
    }
  }
  return look.str();
}

// Any two presets, and those with an axis by their axis too.
TEST(ClipMarkers, everyPresetLooksDifferent) {
  std::vector<std::pair<std::string, ClipConstraint>> kinds = {{"hinge", hingeClip(Axis::z)},
                                                               {"plane", planeClip(Axis::y)}};
  for (const ClipPresetTraits& preset : clipPresets()) kinds.emplace_back(preset.name, preset.constraint({}));
  std::set<std::string> looks;
  for (const auto& [type, constraint] : kinds) {
    const std::string look = lookOf(type, constraint);
    EXPECT_FALSE(look.empty()) << type;
    EXPECT_TRUE(looks.insert(look).second) << type << " looks like another kind";
  }
}

MarkerArray markersNamed(const std::vector<std::pair<std::string, int>>& names) {
  MarkerArray array;
  for (const auto& [name, id] : names) {
    Marker marker;
    marker.ns = name;
    marker.id = id;
    array.markers.push_back(marker);
  }
  return array;
}

TEST(Deletions, WhatIsGoneIsDeletedOnce) {
  std::set<std::pair<std::string, int>> shown;
  EXPECT_EQ(withDeletions(markersNamed({{"a", 0}, {"a", 1}, {"b", 0}}), shown).markers.size(), 3u);
  const MarkerArray next = withDeletions(markersNamed({{"a", 0}}), shown);
  ASSERT_EQ(next.markers.size(), 3u);
  EXPECT_EQ(next.markers[0].action, Marker::ADD);
  EXPECT_EQ(next.markers[1].ns + std::to_string(next.markers[1].id), "a1");
  EXPECT_EQ(next.markers[1].action, Marker::DELETE);
  EXPECT_EQ(next.markers[2].ns, "b");
  EXPECT_EQ(withDeletions(markersNamed({{"a", 0}}), shown).markers.size(), 1u);
}

TEST(Markers, farAwayPointsAreSeenFromOneOfThem) {
  Marker marker;
  marker.pose.position.x = 3.0;
  marker.pose.orientation.z = marker.pose.orientation.w = std::sqrt(0.5);  // a quarter turn about z
  for (int i = 0; i < 3; ++i) {
    geometry_msgs::Point point;
    point.x = 1e6 + 0.25 * i;
    point.y = -2e6;
    marker.points.push_back(point);
  }
  const Marker seen = nearItsPoints(marker);
  const auto world = [](const Marker& m, std::size_t i) {
    return Eigen::Vector3d(m.pose.position.x - m.points[i].y, m.pose.position.y + m.points[i].x, 0.0);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR((world(seen, i) - world(marker, i)).norm(), 0.0, 1e-8);
    EXPECT_EQ(static_cast<double>(static_cast<float>(seen.points[i].x)), 0.25 * static_cast<double>(i));
  }
  for (geometry_msgs::Point& point : marker.points) point.x -= 1e6;
  for (geometry_msgs::Point& point : marker.points) point.y += 2e6;
  EXPECT_EQ(nearItsPoints(marker).points[1].x, 0.25);
  EXPECT_EQ(nearItsPoints(marker).pose.position.x, 3.0);
}

}  // namespace
}  // namespace cable_variation_ros
