// Messages that would stop RViz, or read beyond their ends.
#include <rviz_plugins/displays/message_checks.h>

#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

cable_variation::CableTubes tubes() {
  cable_variation::CableTubes all;
  cable_variation::CableTube tube;
  tube.cable = "main";
  tube.position = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};
  tube.radius = {0.1F, 0.1F};
  cable_variation::CableQuantity quantity;
  quantity.name = "force";
  quantity.maximum = 2.0F;
  quantity.values = {1.0F, 2.0F};
  tube.quantities.push_back(quantity);
  all.cables.push_back(tube);
  return all;
}

TEST(TubeChecks, FindNothingWhereNothingIsWrong) {
  EXPECT_EQ(faultOf(cable_variation::CableTubes()), "");
  EXPECT_EQ(faultOf(tubes()), "");
}

TEST(TubeChecks, FindWhatCannotBeDrawn) {
  const auto faultWith = [](const std::function<void(cable_variation::CableTubes&)>& spoil) {
    cable_variation::CableTubes spoilt = tubes();
    spoil(spoilt);
    return faultOf(spoilt);
  };
  EXPECT_NE(faultWith([](auto& t) { t.origin.x = kNan; }), "");
  for (const float bad : {kNan, kInfinity, -kInfinity, 1e10F}) {
    EXPECT_EQ(faultWith([&](auto& t) { t.cables[0].position[4] = bad; }),
              "cable 'main': a position is not finite");
    EXPECT_NE(faultWith([&](auto& t) { t.cables[0].radius[1] = bad; }), "");
  }
  EXPECT_NE(faultWith([](auto& t) { t.cables[0].radius[0] = -0.1F; }), "");
  EXPECT_NE(faultWith([](auto& t) { t.cables[0].position.pop_back(); }), "");
  EXPECT_NE(faultWith([](auto& t) { t.cables[0].quantities[0].values.pop_back(); }), "");
  EXPECT_NE(faultWith([](auto& t) { t.cables[0].quantities[0].maximum = -1.0F; }), "");
  EXPECT_NE(faultWith([](auto& t) { t.cables[0].quantities[0].minimum = kNan; }), "");
}

TEST(TubeChecks, LeaveValuesThatAreNoNumbers) {
  cable_variation::CableTubes some = tubes();
  some.cables[0].quantities[0].values = {kNan, kInfinity};
  EXPECT_EQ(faultOf(some), "");
}

TEST(EnvelopeChecks, FindVerticesThatAreNotThereOrNotFinite) {
  cable_variation::EnvelopeMesh envelope;
  envelope.mesh.vertices.resize(3);
  envelope.mesh.triangles.resize(1);
  envelope.mesh.triangles[0].vertex_indices = {0, 1, 2};
  EXPECT_EQ(faultOf(envelope), "");
  envelope.mesh.triangles[0].vertex_indices[2] = 3;
  EXPECT_EQ(faultOf(envelope), "a triangle has vertex 3 of 3");
  envelope.mesh.triangles.clear();
  envelope.mesh.vertices[1].z = kInfinity;
  EXPECT_EQ(faultOf(envelope), "a vertex is not finite");
}

TEST(LabelChecks, FindPlacesThatAreNotFinite) {
  cable_variation::Labels labels;
  labels.labels.resize(1);
  labels.labels[0].text = "WH_Start";
  EXPECT_EQ(faultOf(labels), "");
  labels.labels[0].at.y = kNan;
  EXPECT_EQ(faultOf(labels), "the place of 'WH_Start' is not finite");
}

}  // namespace
}  // namespace cable_variation_rviz
