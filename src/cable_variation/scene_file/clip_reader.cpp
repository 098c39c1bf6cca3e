#include <array>
#include <optional>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene_file/pose_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

using Keys = std::vector<std::string>;

Axis readAxis(const YamlCursor& clip, const std::string& key) {
  return static_cast<Axis>(clip.choice(key, {"x", "y", "z"}));
}

GrommetStiffness readStiffness(const YamlCursor& clip) {
  GrommetStiffness stiffness;
  const auto springs = clip.require("stiffness");
  if (springs && springs->checkKeys({"axial", "radial", "torsional", "conical"})) {
    stiffness.axial = springs->number("axial", quantity::spring, Range::positive());
    stiffness.radial = springs->number("radial", quantity::spring, Range::positive());
    stiffness.torsional = springs->number("torsional", quantity::torsion_spring, Range::positive());
    stiffness.conical = springs->number("conical", quantity::torsion_spring, Range::positive());
  }
  return stiffness;
}

std::array<ClipFreedom, 3> readFreedoms(const YamlCursor& clip, const std::string& key,
                                        const Quantity& stiffness) {
  std::array<ClipFreedom, 3> freedoms;
  const auto list = clip.require(key);
  if (!list) return freedoms;
  const std::vector<YamlCursor> items = list->items(3);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const YamlCursor& item = items[i];
    if (item.isMap()) {
      if (!item.checkKeys({"stiffness"})) continue;
      freedoms[i] = ClipFreedom::sprung(item.number("stiffness", stiffness, Range::positive()));
    } else if (item.isScalar() && (item.text() == "locked" || item.text() == "free")) {
      freedoms[i] = item.text() == "locked" ? ClipFreedom::locked() : ClipFreedom::free();
    } else {
      item.fail((item.isScalar() ? "found '" + item.text() + "'" : std::string("found a list")) +
                "; expected locked, free or {stiffness: ...}");
    }
  }
  return freedoms;
}

// How a parameter is written: its key, and how it is read.
struct ParameterForm {
  ClipParameter parameter;
  const char* key;
  void (*read)(const YamlCursor& clip, ClipParameters& given);
};

using From = const YamlCursor&;
using Given = ClipParameters&;
constexpr std::array<ParameterForm, enumeratorCount<ClipParameter>()> kParameters{{
    {ClipParameter::axis, "axis", [](From clip, Given given) { given.axis = readAxis(clip, "axis"); }},
    {ClipParameter::normal, "normal",
     [](From clip, Given given) { given.normal = readAxis(clip, "normal"); }},
    {ClipParameter::rolls, "rolls", [](From clip, Given given) { given.rolls = clip.flag("rolls", false); }},
    {ClipParameter::stiffness, "stiffness",
     [](From clip, Given given) { given.stiffness = readStiffness(clip); }},
    {ClipParameter::translation, "translation",
     [](From clip, Given given) { given.translation = readFreedoms(clip, "translation", quantity::spring); }},
    {ClipParameter::rotation, "rotation",
     [](From clip, Given given) {
       given.rotation = readFreedoms(clip, "rotation", quantity::torsion_spring);
     }},
    {ClipParameter::slides, "slides",
     [](From clip, Given given) { given.slides = clip.flag("slides", false); }},
}};
static_assert(hasRowOfEach(kParameters, &ParameterForm::parameter), "a parameter has no row");

const ParameterForm& formOf(ClipParameter parameter) {
  return kParameters[static_cast<std::size_t>(parameter)];
}

const ClipPresetTraits* readPreset(const YamlCursor& clip) {
  Keys names;
  for (const ClipPresetTraits& traits : clipPresets()) names.emplace_back(traits.name);
  const auto value = clip.require("type");
  if (!value) return nullptr;
  const std::size_t before = clip.faults().count();
  const std::size_t index = value->choice(names);
  return clip.faults().count() > before ? nullptr : &clipPresets()[index];
}

// The keys of a preset beyond those of all clips.
Keys keysOf(const ClipPresetTraits& traits) {
  Keys keys = traits.mounted ? Keys{"component", "pose", "attached"} : Keys{"force", "moment"};
  for (const auto& parameter : traits.parameters) {
    if (parameter) keys.emplace_back(formOf(*parameter).key);
  }
  return keys;
}

ClipConstraint readConstraint(const YamlCursor& clip, const ClipPresetTraits& traits) {
  ClipParameters given;
  for (const auto& parameter : traits.parameters) {
    if (parameter) formOf(*parameter).read(clip, given);
  }
  return traits.constraint(given);
}

void readMount(const YamlCursor& clip, ClipMount& mount, const ReadContext& context) {
  if (const auto component = clip.find("component")) {
    mount.component = component->text();
    if (!mount.component.empty() && mount.component != "world") context.components.find(*component);
  }
  if (const auto pose = clip.require("pose")) mount.pose = readPose(*pose);
}

void readForces(const YamlCursor& owner, PointLoad& load) {
  load.force = owner.vector("force", quantity::force, Eigen::Vector3d::Zero());
  load.moment = owner.vector("moment", quantity::moment, Eigen::Vector3d::Zero());
}

// Cable and arc length that a clip or load acts at.
void readPlace(const YamlCursor& item, const ReadContext& context, std::size_t& cable, double& arc_length) {
  const std::size_t found = context.cables.find(item, "cable");
  const bool known = found != NameTable::npos;
  cable = known ? found : 0;
  if (const auto at = item.require("at")) {
    arc_length = readArcLength(*at, context.cableLength(found));
  }
}

void readClip(const YamlCursor& item, Clip& clip, ClipMount& mount, ReadContext& context) {
  Keys keys{"name", "type", "cable", "at"};
  if (!item.isMap()) {
    item.checkKeys(keys);
    return;
  }
  const ClipPresetTraits* preset = readPreset(item);
  if (preset) {
    const Keys more = keysOf(*preset);
    keys.insert(keys.end(), more.begin(), more.end());
    item.checkKeys(keys);
    clip.type = preset->name;
    clip.constraint = readConstraint(item, *preset);
  }
  readPlace(item, context, clip.cable, clip.arc_length);
  if (!preset) return;
  if (preset->mounted) {
    readMount(item, mount, context);
    clip.attached = item.flag("attached", true);
  } else if (item.has("force") || item.has("moment")) {
    PointLoad load;
    load.name = clip.name;
    load.cable = clip.cable;
    load.arc_length = clip.arc_length;
    readForces(item, load);
    context.scene.harness.loads.push_back(std::move(load));
  }
}

}  // namespace

void readClips(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.clips, context.scene.harness.clips, [&](const YamlCursor& item, Clip& clip) {
    ClipMount mount;
    readClip(item, clip, mount, context);
    context.scene.clip_mounts.push_back(std::move(mount));
  });
}

void readLoads(const YamlCursor& list, ReadContext& context) {
  readEach(list, context.loads, context.scene.harness.loads, [&](const YamlCursor& item, PointLoad& load) {
    if (!item.checkKeys({"name", "cable", "at", "force", "moment"})) return;
    readPlace(item, context, load.cable, load.arc_length);
    readForces(item, load);
    if (!item.has("force") && !item.has("moment")) item.fail("'force' or 'moment' is missing");
  });
}

}  // namespace cable_variation
