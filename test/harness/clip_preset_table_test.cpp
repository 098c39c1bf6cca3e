#include <cable_variation/harness/clip_preset.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

bool same(const ClipConstraint& a, const ClipConstraint& b) {
  const auto equal = [](const ClipFreedom& x, const ClipFreedom& y) {
    return x.kind == y.kind && x.stiffness == y.stiffness;
  };
  return std::equal(a.translation.begin(), a.translation.end(), b.translation.begin(), equal) &&
         std::equal(a.rotation.begin(), a.rotation.end(), b.rotation.begin(), equal) && a.slides == b.slides;
}

// The defaults but for one parameter.
ClipParameters with(ClipParameter parameter) {
  ClipParameters given;
  switch (parameter) {
    case ClipParameter::axis:
      given.axis = Axis::y;
      break;
    case ClipParameter::normal:
      given.normal = Axis::z;
      break;
    case ClipParameter::rolls:
      given.rolls = true;
      break;
    case ClipParameter::stiffness:
      given.stiffness = {1.0, 2.0, 3.0, 4.0};
      break;
    case ClipParameter::translation:
      given.translation[1] = ClipFreedom::free();
      break;
    case ClipParameter::rotation:
      given.rotation[2] = ClipFreedom::sprung(5.0);
      break;
    case ClipParameter::slides:
      given.slides = true;
      break;
  }
  return given;
}

TEST(ClipPresetTable, everyPresetHasItsRowAndItsName) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < clipPresets().size(); ++i) {
    const ClipPresetTraits& traits = traitsOf(static_cast<ClipPreset>(i));
    Clip clip;
    clip.type = traits.name;
    EXPECT_EQ(presetOf(clip), static_cast<ClipPreset>(i)) << traits.name;
    EXPECT_EQ(isMounted(clip), clip.type != "free");
    EXPECT_TRUE(names.insert(traits.name).second) << traits.name << " is there twice";
  }
  EXPECT_THROW(traitsOf(static_cast<ClipPreset>(clipPresets().size())), std::out_of_range);
}

TEST(ClipPresetTable, anotherNameIsGeneral) {
  Clip clip;
  clip.type = "tied with a rope";
  EXPECT_EQ(presetOf(clip), ClipPreset::general);
  EXPECT_TRUE(isMounted(clip));
}

TEST(ClipPresetTable, aPresetHeedsTheParametersThatItTakesAndNoOthers) {
  for (const ClipPresetTraits& traits : clipPresets()) {
    const ClipConstraint usual = traits.constraint({});
    for (std::size_t i = 0; i < enumeratorCount<ClipParameter>(); ++i) {
      const auto parameter = static_cast<ClipParameter>(i);
      const bool takes =
          std::find(traits.parameters.begin(), traits.parameters.end(), parameter) != traits.parameters.end();
      EXPECT_EQ(!same(traits.constraint(with(parameter)), usual), takes)
          << traits.name << ", parameter " << i;
    }
  }
}

TEST(ClipPresetTable, everyPresetIsDescribedWhereScenesAre) {
  std::ifstream file("../doc/scene_file.md");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const ClipPresetTraits& traits : clipPresets())
    EXPECT_NE(text.find("| `" + std::string(traits.name) + "` |"), std::string::npos) << traits.name;
}

}  // namespace
}  // namespace cable_variation
