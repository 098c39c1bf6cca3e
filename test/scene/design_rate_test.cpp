// Analytic derivatives of harnessAt() and componentPosesAt() against central differences of them.
#include <cable_variation/scene/design_rate.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// everything.yaml and variables of a component that carries another, of all axes of a clip, of a
// length that what is attached keeps its distance from the start of.
Scene manyVariables() {
  Scene scene = readScene(findTestPackage("test_data") + "/scenes/everything.yaml", findTestPackage);
  const auto add = [&](const std::string& name, const DesignTarget& target, double nominal,
                       double tolerance) {
    DesignVariable variable;
    variable.name = name;
    variable.target = target;
    variable.nominal = nominal;
    variable.lower = -tolerance;
    variable.upper = tolerance;
    scene.design_variables.push_back(variable);
  };
  constexpr std::size_t kBracket = 1, kEngine = 2;
  constexpr std::size_t kRolling = 3;  // a clip of the world
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const std::string suffix = std::to_string(static_cast<int>(axis));
    add("rolling_t" + suffix, ClipTranslation{kRolling, axis}, 0.0, 0.01);
    add("rolling_r" + suffix, ClipRotation{kRolling, axis}, 0.0, 0.3);
    add("engine_t" + suffix, ComponentTranslation{kEngine, axis}, 0.0, 0.01);
    add("engine_r" + suffix, ComponentRotation{kEngine, axis}, 0.0, 0.3);
  }
  add("fixed_rz", ClipRotation{0, Axis::z}, 0.0, 0.3);
  add("bracket_ry", ComponentRotation{kBracket, Axis::y}, 0.0, 0.2);
  for (std::size_t locator = 1; locator < 6; ++locator) {
    add("bracket_locator_" + std::to_string(locator), LocatorDeviation{kBracket, locator}, 0.0, 0.002);
  }
  add("branch_length", CableProperty{1, CableProperty::Property::length}, 0.15, 0.004);
  add("stepped_radius", CableProperty{3, CableProperty::Property::radius, true}, 0.012, 0.001);
  return scene;
}

// All numbers of a harness, rotations as rotation vectors from those of `reference`.
VectorXd numbersOf(const Harness& harness, const Harness& reference) {
  std::vector<double> all;
  const auto put = [&](const Vector3d& v) { all.insert(all.end(), v.data(), v.data() + 3); };
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    put(clip.pose.position);
    put(so3::log(clip.pose.orientation * reference.clips[i].pose.orientation.conjugate()));
    all.push_back(clip.arc_length);
  }
  for (const Joint& joint : harness.joints) {
    all.insert(all.end(), {joint.parent_arc_length, joint.child_arc_length});
  }
  for (const PointLoad& load : harness.loads) all.push_back(load.arc_length);
  for (const Cable& cable : harness.cables) {
    all.push_back(cable.length);
    for (const SectionAt& knot : cable.sections) {
      const Section& s = knot.section;
      all.insert(all.end(),
                 {knot.arc_length, s.EA, s.GA_y, s.GA_z, s.GJ, s.EI_y, s.EI_z, s.mass_per_length, s.radius});
    }
    for (const RestCurvatureAt& knot : cable.rest_curvature) {
      all.push_back(knot.arc_length);
      put(knot.curvature);
    }
  }
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// The same numbers' derivatives, as a HarnessRate tells them.
VectorXd numbersOf(const HarnessRate& rate, const Harness& at) {
  std::vector<FrameRate> frames(at.clips.size());
  std::vector<double> clips(at.clips.size()), parents(at.joints.size()), children(at.joints.size()),
      loads(at.loads.size());
  std::vector<CableRate> cables(at.cables.size());
  for (const auto& [i, frame] : rate.clip_frames) frames[i] = frame;
  for (const auto& [i, value] : rate.clip_arc_lengths) clips[i] = value;
  for (const auto& [i, value] : rate.parent_arc_lengths) parents[i] = value;
  for (const auto& [i, value] : rate.child_arc_lengths) children[i] = value;
  for (const auto& [i, value] : rate.load_arc_lengths) loads[i] = value;
  for (const CableRate& cable : rate.cables) cables[cable.cable] = cable;

  std::vector<double> all;
  const auto put = [&](const Vector3d& v) { all.insert(all.end(), v.data(), v.data() + 3); };
  for (std::size_t i = 0; i < frames.size(); ++i) {
    put(frames[i].translation);
    put(frames[i].rotation);
    all.push_back(clips[i]);
  }
  for (std::size_t i = 0; i < parents.size(); ++i) all.insert(all.end(), {parents[i], children[i]});
  all.insert(all.end(), loads.begin(), loads.end());
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const CableRate& c = cables[i];
    all.push_back(c.length);
    for (const SectionAt& knot : at.cables[i].sections) {
      const Section& s = knot.section;
      all.insert(all.end(), {c.knots * knot.arc_length, c.stiffness[0] * s.EA, c.stiffness[1] * s.GA_y,
                             c.stiffness[2] * s.GA_z, c.stiffness[3] * s.GJ, c.stiffness[4] * s.EI_y,
                             c.stiffness[5] * s.EI_z, c.mass * s.mass_per_length, c.radius * s.radius});
    }
    for (const RestCurvatureAt& knot : at.cables[i].rest_curvature) {
      all.push_back(c.knots * knot.arc_length);
      put(c.rest_curvature * knot.curvature);
    }
  }
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

VectorXd numbersOf(const Scene& scene, const ComponentPoses& poses, const ComponentPoses& reference) {
  VectorXd all(6 * static_cast<Eigen::Index>(scene.components.size()));
  Eigen::Index row = 0;
  for (const Component& component : scene.components) {
    const Pose& pose = poses.at(component.name);
    all.segment<3>(row) = pose.position;
    all.segment<3>(row + 3) =
        so3::log(pose.orientation * reference.at(component.name).orientation.conjugate());
    row += 6;
  }
  return all;
}

// Fourth order: the truncation is the fourth power of the step (times 1 / 0.1 m for locators), the rounding
// 1e-16 over it.
VectorXd centralDifference(const std::function<VectorXd(double)>& f, double step) {
  return (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step);
}

void expectClose(const VectorXd& a, const VectorXd& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const double scale = std::max(1.0, std::abs(b[i]));
    EXPECT_NEAR(a[i], b[i], 1e-8 * scale) << what << ", number " << i;
  }
}

void compareWithDifferences(const Scene& scene, const DesignValues& values, const ComponentPoses& moved) {
  const Harness at = harnessAt(scene, values, moved);
  const ComponentPoses poses = componentPosesAt(scene, values, moved);
  std::vector<std::size_t> all(scene.design_variables.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const std::vector<DesignRate> rates = designRates(scene, values, moved, all);
  ASSERT_EQ(rates.size(), all.size());
  for (const std::size_t i : all) {
    const DesignVariable& variable = scene.design_variables[i];
    const auto found = values.find(variable.name);
    const double value = found == values.end() ? variable.nominal : found->second;
    const auto with = [&](double step) {
      DesignValues stepped = values;
      stepped[variable.name] = value + step;
      return stepped;
    };
    const double step = 2e-4 * (value == 0.0 ? 1.0 : std::min(1.0, std::abs(value)));
    const VectorXd harness =
        centralDifference([&](double h) { return numbersOf(harnessAt(scene, with(h), moved), at); }, step);
    expectClose(numbersOf(rates[i].harness, at), harness, variable.name);
    EXPECT_GT(harness.cwiseAbs().maxCoeff(), 0.0) << variable.name << " changes nothing";

    VectorXd components = VectorXd::Zero(6 * static_cast<Eigen::Index>(scene.components.size()));
    for (const auto& [component, rate] : rates[i].components) {
      components.segment<6>(6 * static_cast<Eigen::Index>(component)) << rate.translation, rate.rotation;
    }
    const VectorXd differences = centralDifference(
        [&](double h) { return numbersOf(scene, componentPosesAt(scene, with(h), moved), poses); }, step);
    expectClose(components, differences, variable.name + ", components");
  }
}

TEST(DesignRate, IsTheDerivativeAtTheNominalDesign) { compareWithDifferences(manyVariables(), {}, {}); }

TEST(DesignRate, IsTheDerivativeAwayFromIt) {
  const Scene scene = manyVariables();
  DesignValues values;
  double share = 0.9;
  for (const DesignVariable& variable : scene.design_variables) {
    values[variable.name] = variable.nominal + share * (share > 0.0 ? variable.upper : -variable.lower);
    share = share > 0.0 ? -0.7 * share : 0.95 + 0.5 * share;
  }
  const ComponentPoses moved{
      {"engine", {{0.4, -0.3, 0.2}, Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Vector3d(0.6, 0.0, 0.8)))}}};
  compareWithDifferences(scene, values, moved);
}

// A value given as nominal is the same as none, whatever else is varied: neither order nor presence counts.
TEST(DesignRate, AVariableAtItsNominalChangesNothing) {
  const Scene scene = manyVariables();
  const DesignValues some{{"hose_length", 0.332}, {"radius", 0.0041}, {"main_length", 0.314}};
  DesignValues all = some;
  for (const DesignVariable& variable : scene.design_variables) all.emplace(variable.name, variable.nominal);
  const Harness a = harnessAt(scene, some), b = harnessAt(scene, all);
  EXPECT_LT((numbersOf(a, a) - numbersOf(b, a)).cwiseAbs().maxCoeff(), 1e-12);
}

// A component that is carried by another and carries clips, moved as motions do: by its pose in the world.
TEST(DesignRate, OfARigidMotionIsTheDerivativeByThePose) {
  const Scene scene = manyVariables();
  const Pose pose{{0.4, -0.3, 0.2}, Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Vector3d(0.6, 0.0, 0.8)))};
  const ComponentPoses moved{{"engine", pose}};
  const DesignValues values{{"engine_t0", 0.004}, {"engine_r1", 0.1}};
  const auto rates = rigidMotionRates(scene, values, moved, "engine");
  const Harness at = harnessAt(scene, values, moved);
  for (int k = 0; k < 6; ++k) {
    const auto with = [&](double step) {
      const Vector3d along = Vector3d::Unit(k % 3);
      Pose there = pose;
      if (k < 3)
        there.position += step * along;
      else
        there.orientation = so3::exp(step * along) * pose.orientation;
      return ComponentPoses{{"engine", there}};
    };
    const VectorXd harness =
        centralDifference([&](double h) { return numbersOf(harnessAt(scene, values, with(h)), at); }, 2e-4);
    expectClose(numbersOf(rates[static_cast<std::size_t>(k)].harness, at), harness,
                "motion " + std::to_string(k));
    EXPECT_GT(harness.cwiseAbs().maxCoeff(), 0.0);
  }
  EXPECT_THROW(rigidMotionRates(scene, values, moved, "world"), std::invalid_argument);
}

TEST(DesignRate, TellsOnlyWhatChanges) {
  const Scene scene = manyVariables();
  const DesignRate turn = designRates(scene, {}, {}, {0}).front();  // clip_turn
  EXPECT_EQ(turn.harness.clip_frames.size(), 1U);
  EXPECT_TRUE(turn.harness.cables.empty());
  EXPECT_TRUE(turn.components.empty());
}

TEST(DesignRate, RefusesWhatIsNotThere) {
  const Scene scene = manyVariables();
  EXPECT_THROW(designRates(scene, {{"nothing", 0.0}}, {}, {0}), std::invalid_argument);
  EXPECT_THROW(designRates(scene, {{"clip_turn", std::numeric_limits<double>::quiet_NaN()}}, {}, {0}),
               std::invalid_argument);
  EXPECT_THROW(designRates(scene, {}, {}, {scene.design_variables.size()}), std::invalid_argument);
  const auto weight = static_cast<std::size_t>(
      std::find_if(scene.design_variables.begin(), scene.design_variables.end(),
                   [](const DesignVariable& variable) { return variable.name == "weight"; }) -
      scene.design_variables.begin());
  EXPECT_THROW(designRates(scene, {{"weight", 0.0}}, {}, {weight}), std::invalid_argument)
      << "a change relative to 0";
}

}  // namespace
}  // namespace cable_variation
