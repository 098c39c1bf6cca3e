#include <cable_variation/harness/clip_preset.h>

namespace cable_variation {
namespace {

using Preset = ClipPreset;
using Parameter = ClipParameter;
using Given = const ClipParameters&;

constexpr bool kMounted = true;

constexpr ClipPresetTable kPresets{{
    {Preset::fixed, "fixed", kMounted, {}, [](Given) { return fixedClip(); }},
    {Preset::rolling, "rolling", kMounted, {}, [](Given) { return rollingClip(); }},
    {Preset::pivot, "pivot", kMounted, {}, [](Given) { return pivotClip(); }},
    {Preset::hinge, "hinge", kMounted, {Parameter::axis}, [](Given given) { return hingeClip(given.axis); }},
    {Preset::sliding, "sliding", kMounted, {}, [](Given) { return slidingClip(); }},
    {Preset::sliding_rolling, "sliding_rolling", kMounted, {}, [](Given) { return slidingRollingClip(); }},
    {Preset::eyelet, "eyelet", kMounted, {}, [](Given) { return eyeletClip(); }},
    {Preset::guide,
     "guide",
     kMounted,
     {Parameter::rolls},
     [](Given given) { return guideClip(given.rolls); }},
    {Preset::plane,
     "plane",
     kMounted,
     {Parameter::normal},
     [](Given given) { return planeClip(given.normal); }},
    {Preset::grommet,
     "grommet",
     kMounted,
     {Parameter::stiffness, Parameter::slides},
     [](Given given) { return grommetClip(given.stiffness, given.slides); }},
    {Preset::general,
     "general",
     kMounted,
     {Parameter::translation, Parameter::rotation, Parameter::slides},
     [](Given given) {
       return ClipConstraint{given.translation, given.rotation, given.slides};
     }},
    {Preset::free, "free", false, {}, [](Given) { return freeClip(); }},
}};
static_assert(hasRowOfEach(kPresets, &ClipPresetTraits::preset), "a preset has no row, or is out of order");

}  // namespace

const ClipPresetTable& clipPresets() { return kPresets; }

const ClipPresetTraits& traitsOf(ClipPreset preset) { return kPresets.at(static_cast<std::size_t>(preset)); }

ClipPreset presetOf(const Clip& clip) {
  for (const ClipPresetTraits& traits : kPresets) {
    if (clip.type == traits.name) return traits.preset;
  }
  return ClipPreset::general;
}

bool canBeAdded(const ClipPresetTraits& traits) {
  bool complete = traits.mounted;
  for (const auto& parameter : traits.parameters) {
    if (parameter && *parameter != ClipParameter::rolls && *parameter != ClipParameter::slides)
      complete = false;
  }
  return complete;
}

bool isMounted(const Clip& clip) { return traitsOf(presetOf(clip)).mounted; }

}  // namespace cable_variation
