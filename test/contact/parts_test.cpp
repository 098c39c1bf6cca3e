// Cables that touch planes, boxes and cylinders: no part is entered, parts only push, all forces balance, and
// how a part is divided into triangles is no matter.

#include <random>

#include <gtest/gtest.h>

#include <contact/contact_cases.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRadius = 0.004;

Section soft(double mass_per_length = 0.1) {
  return roundSection(1e4, 4e3, 8e-3, 1e-2, mass_per_length, kRadius);
}

// Forces and moments about the origin of all that acts on a single cable.
void expectBalance(const Harness& harness, const Equilibrium& result, double tolerance) {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  double scale = 0.0;
  for (const Reaction& reaction : result.clip_reactions) {
    force += reaction.force;
    moment += reaction.moment + reaction.section.position.cross(reaction.force);
    scale += reaction.force.norm();
  }
  for (const ContactInterval& interval : result.contacts) {
    force += interval.force;
    // a part presses at its surface, towards the centreline
    moment += interval.moment;
    scale += interval.total;
  }
  const CableShape& shape = result.shapes[0];
  const double mass = harness.cables[0].sections[0].section.mass_per_length;
  const std::size_t count = 20001;
  const double step = harness.cables[0].length / static_cast<double>(count - 1);
  const std::vector<Pose> places = shape.sample(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = i == 0 || i + 1 == count ? 0.5 * step : step;
    const Vector3d weight = share * mass * harness.gravity;
    force += weight;
    moment += places[i].position.cross(weight);
    scale += weight.norm();
  }
  EXPECT_LT(force.norm(), tolerance * scale);
  EXPECT_LT(moment.norm(), tolerance * scale * harness.cables[0].length);
}

TEST(Parts, AnswerDoesNotDependOnTriangles) {
  Harness harness = clamped(uniformCable(0.5, soft()), poseAt(0.4, 0.05, 0.03));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  std::vector<Equilibrium> results;
  for (const int fields : {1, 100}) {
    harness.contacts = {
        contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5), fields, fields))};
    results.push_back(EquilibriumSolver().solve(harness));
    ASSERT_TRUE(results.back().converged()) << fields << ": " << results.back().message;
    ASSERT_FALSE(results.back().contacts.empty());
  }
  for (double s = 0.0; s <= 0.5; s += 0.005) {
    EXPECT_LT((results[0].shapes[0].position(s) - results[1].shapes[0].position(s)).norm(), 1e-6) << s;
  }
  EXPECT_NEAR(contactForce(results[0]).z(), contactForce(results[1]).z(),
              1e-6 * contactForce(results[0]).z());
}

// Along the edges of the triangles, too, where most of them meet.
TEST(Parts, EdgesOfAFlatFaceAreNone) {
  Harness harness = cantilever(uniformCable(0.5, soft()));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.03);
  std::vector<Equilibrium> results;
  for (const int rows : {1, 2, 64}) {
    harness.contacts = {
        contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5), 3 * rows, rows))};
    results.push_back(EquilibriumSolver().solve(harness));
    ASSERT_TRUE(results.back().converged()) << rows << ": " << results.back().message;
    for (double s = 0.0; s <= 0.5; s += 0.01)
      EXPECT_LT((results[0].shapes[0].position(s) - results.back().shapes[0].position(s)).norm(), 1e-6) << s;
  }
}

TEST(Parts, StandOffIsKept) {
  Harness harness = cantilever(uniformCable(0.5, soft()));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.03);
  harness.contacts = {contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5)), {}, 0.002)};
  const Equilibrium result = EquilibriumSolver().solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_NEAR(result.shapes[0].position(0.45).z(), kRadius + 0.002, 1e-5);
  EXPECT_NEAR(result.smallest_gap, 0.0, 1e-5);
}

// What a section bears is what its side of the cable is pressed with and weighs.
TEST(Parts, SectionForcesBalanceWhatPressesBetweenThem) {
  Harness harness = clamped(uniformCable(0.5, soft()), poseAt(0.4, 0.05, 0.03));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  harness.contacts = {contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5)))};
  const Equilibrium result = EquilibriumSolver().solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  ASSERT_FALSE(result.contacts.empty());
  const double mass = harness.cables[0].sections[0].section.mass_per_length;
  const double whole = mass * harness.cables[0].length * harness.gravity.norm();
  const std::vector<ShapePoint>& points = result.shapes[0].points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Vector3d sum = points[i + 1].force - points[i].force;
    sum += (points[i + 1].arc_length - points[i].arc_length) * mass * harness.gravity;
    for (const ContactInterval& interval : result.contacts) {
      for (const ContactForce& place : interval.places) {
        const bool between =
            place.arc_length >= points[i].arc_length && place.arc_length < points[i + 1].arc_length;
        if (between) sum += place.force * place.direction;
      }
    }
    EXPECT_LT(sum.norm(), 1e-3 * whole) << "from " << points[i].arc_length;
  }
}

// A clip that holds its cable in a part leaves nothing to solve; what lies in its holder is skipped.
TEST(Parts, AClipInsideAPartIsNamed) {
  Harness harness = clamped(uniformCable(0.5, soft()), poseAt(0.4, 0.0, 0.003));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  harness.contacts = {contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5)))};
  EquilibriumSolver solver;
  const Equilibrium inside = solver.solve(harness);
  EXPECT_EQ(inside.status, EquilibriumStatus::impossible);
  EXPECT_NE(inside.message.find("clip '" + harness.clips[1].name + "' holds cable"), std::string::npos)
      << inside.message;
  EXPECT_NE(inside.message.find("3 mm from part 'table'"), std::string::npos) << inside.message;
  harness.contacts[0].own_clips = {1};
  harness.contacts[0].skip_near_clips = 0.05;
  const Equilibrium skipped = solver.solve(harness);
  EXPECT_TRUE(skipped.converged()) << skipped.message;
}

TEST(Parts, ARadiusThatChangesIsRefusedWhereTheCableSlides) {
  Harness harness = clamped(uniformCable(0.5, soft()), poseAt(0.4, 0.0, 0.05));
  harness.contacts = {contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5)))};
  Section thicker = soft();
  thicker.radius = 2.0 * kRadius;
  harness.cables[0].sections.push_back({0.5, thicker});
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  EXPECT_NO_THROW(validate(harness));
  harness.clips.push_back(clipOn(0, "ring", 0.25, slidingClip(), poseAt(0.2, 0.0, 0.05)));
  try {
    EquilibriumSolver().solve(harness);
    ADD_FAILURE() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("slides through clip 'ring'"), std::string::npos)
        << error.what();
  }
}

// Random cables over planes and boxes, some standing at an angle.
TEST(Parts, RandomFamily) {
  std::mt19937 random(14);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int touching_planes = 0, touching_boxes = 0;
  constexpr int kCases = 40;
  for (int i = 0; i < kCases; ++i) {
    const double length = uniform(0.3, 0.6);
    Harness harness = clamped(uniformCable(length, soft(uniform(0.02, 0.3))),
                              poseAt(uniform(0.6, 0.95) * length, uniform(-0.05, 0.05), uniform(-0.03, 0.05),
                                     {0.0, uniform(-0.3, 0.3), uniform(-0.3, 0.3)}));
    const bool plane = i % 2 == 0;
    const Vector3d size(uniform(0.05, 0.2), uniform(0.05, 0.2), uniform(0.01, 0.05));
    const Pose pose = poseAt(uniform(0.2, 0.6) * length, uniform(-0.02, 0.02),
                             plane ? -uniform(0.05, 0.08) : -uniform(0.05, 0.09),
                             {uniform(-0.2, 0.2), plane ? uniform(-0.05, 0.05) : uniform(-0.2, 0.2), 0.0});
    harness.contacts = {
        plane ? contactWith("part", rectangle(Vector2d(-1.0, -1.0), Vector2d(1.0, 1.0), 7, 7), pose)
              : contactWith("part", box(size), pose)};
    const Equilibrium result = EquilibriumSolver().solve(harness);
    ASSERT_TRUE(result.converged()) << i << ": " << result.message;
    if (!result.contacts.empty()) ++(plane ? touching_planes : touching_boxes);
    for (double s = 0.0; s <= length; s += 1e-3) {
      const Vector3d x = pose.inverse() * result.shapes[0].position(s);
      const double distance = plane ? x.z() : (x.cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm();
      EXPECT_GT(distance, kRadius - 1e-5) << i << " at " << s;
    }
    for (const ContactInterval& interval : result.contacts) {
      for (const ContactForce& place : interval.places) {
        EXPECT_GT(place.force, 0.0);
        const Vector3d x = result.shapes[0].position(place.arc_length);
        EXPECT_NEAR((x - place.on_part).dot(place.direction), kRadius, 2e-5);
      }
    }
    expectBalance(harness, result, 1e-4);
    EXPECT_FALSE(result.smallest_eigenvalue <= 0.0);
    EXPECT_FALSE(result.contacts.empty() && std::isnan(result.smallest_eigenvalue));
  }
  EXPECT_GT(touching_planes, kCases / 4);
  EXPECT_GT(touching_boxes, kCases / 4);
}

}  // namespace
}  // namespace cable_variation::test
