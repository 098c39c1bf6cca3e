#include <cmath>
#include <stdexcept>

#include <cable_variation/scene_file/pose_reader.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

using Keys = std::vector<std::string>;

Axis readAxis(const YamlCursor& clip, const std::string& key) {
  return static_cast<Axis>(clip.choice(key, {"x", "y", "z"}));
}

ClipConstraint readGrommet(const YamlCursor& clip) {
  GrommetStiffness stiffness;
  const std::size_t before = clip.faults().count();
  const auto springs = clip.require("stiffness");
  if (springs && springs->checkKeys({"axial", "radial", "torsional", "conical"})) {
    stiffness.axial = springs->number("axial", quantity::spring, Range::positive());
    stiffness.radial = springs->number("radial", quantity::spring, Range::positive());
    stiffness.torsional = springs->number("torsional", quantity::torsion_spring, Range::positive());
    stiffness.conical = springs->number("conical", quantity::torsion_spring, Range::positive());
  }
  const bool slides = clip.flag("slides", false);
  return clip.faults().count() > before ? ClipConstraint() : grommetClip(stiffness, slides);
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

ClipConstraint readGeneral(const YamlCursor& clip) {
  ClipConstraint constraint;
  constraint.translation = readFreedoms(clip, "translation", quantity::spring);
  constraint.rotation = readFreedoms(clip, "rotation", quantity::torsion_spring);
  constraint.slides = clip.flag("slides", false);
  return constraint;
}

// A clip's type: its name, the keys it takes beyond those of all clips, and how it is read.
struct ClipType {
  std::string name;
  Keys keys;
  ClipConstraint (*read)(const YamlCursor& clip);
};

const std::vector<ClipType>& clipTypes() {
  static const Keys mount{"component", "pose"};
  static const auto with = [](Keys more) {
    more.insert(more.begin(), mount.begin(), mount.end());
    return more;
  };
  static const std::vector<ClipType> types{
      {"fixed", mount, [](const YamlCursor&) { return fixedClip(); }},
      {"rolling", mount, [](const YamlCursor&) { return rollingClip(); }},
      {"pivot", mount, [](const YamlCursor&) { return pivotClip(); }},
      {"hinge", with({"axis"}), [](const YamlCursor& clip) { return hingeClip(readAxis(clip, "axis")); }},
      {"sliding", mount, [](const YamlCursor&) { return slidingClip(); }},
      {"sliding_rolling", mount, [](const YamlCursor&) { return slidingRollingClip(); }},
      {"eyelet", mount, [](const YamlCursor&) { return eyeletClip(); }},
      {"guide", with({"rolls"}), [](const YamlCursor& clip) { return guideClip(clip.flag("rolls", false)); }},
      {"plane", with({"normal"}), [](const YamlCursor& clip) { return planeClip(readAxis(clip, "normal")); }},
      {"grommet", with({"stiffness", "slides"}), readGrommet},
      {"general", with({"translation", "rotation", "slides"}), readGeneral},
      {"free", {"force", "moment"}, [](const YamlCursor&) { return freeClip(); }},
  };
  return types;
}

const ClipType* readType(const YamlCursor& clip) {
  Keys names;
  for (const ClipType& type : clipTypes()) names.push_back(type.name);
  const auto value = clip.require("type");
  if (!value) return nullptr;
  const std::size_t before = clip.faults().count();
  const std::size_t index = value->choice(names);
  return clip.faults().count() > before ? nullptr : &clipTypes()[index];
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
  const ClipType* type = readType(item);
  if (type) {
    keys.insert(keys.end(), type->keys.begin(), type->keys.end());
    item.checkKeys(keys);
    clip.type = type->name;
    clip.constraint = type->read(item);
  }
  readPlace(item, context, clip.cable, clip.arc_length);
  if (!type) return;
  if (clip.type != "free") {
    readMount(item, mount, context);
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
