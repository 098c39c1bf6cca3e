#include <cable_variation/scene_file/scene_writer.h>

#include <cmath>
#include <stdexcept>
#include <variant>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene_file/cable_writer.h>
#include <cable_variation/scene_file/value_text.h>
#include <cable_variation/scene_file/yaml_document.h>
#include <cable_variation/scene_file/yaml_text.h>

namespace cable_variation {
namespace {

constexpr double kUnchanged = 1e-12;  // [m, rad]: what rounding does to a pose that nobody has touched

double turnBetween(const Pose& a, const Pose& b) {
  return 2.0 * (a.orientation.conjugate() * b.orientation).vec().norm();
}

void writePose(const YAML::Node& entry, const Pose& loaded, const Pose& wanted, YamlText& text) {
  const bool moved = (wanted.position - loaded.position).norm() > kUnchanged;
  const bool turned = turnBetween(loaded, wanted) > kUnchanged;
  if (!moved && !turned) return;
  const auto pose = text.valueOf(entry, "pose");
  if (!pose) {
    text.addEntry(entry, "name", "pose", poseText(wanted));
    return;
  }
  const auto position = text.valueOf(entry["pose"], "position");
  const bool own = text.at(*pose).front() != '*';
  if (!turned && position && own) {
    text.replace(*position, positionText(wanted.position));
  } else {
    text.replace(*pose, poseText(wanted));
  }
}

// @param fallback what the file says without the key
void writePlace(const YAML::Node& entry, const char* key, double loaded, double wanted, const Cable& cable,
                const char* behind, YamlText& text) {
  const auto at = text.valueOf(entry, key);
  const std::string before = at ? entry[key].Scalar() : "start";
  const bool is_end = before == "end" && wanted >= cable.length;
  const bool is_start = before == "start" && wanted <= 0.0;
  const bool is_same = before != "end" && before != "start" && wanted == loaded;
  if (is_end || is_start || is_same) return;
  const bool word = before == "end" || before == "start";
  std::string by = lengthText(wanted);
  if (wanted >= cable.length) {
    by = "end";
  } else if (!word && text.at(*at).front() != '*') {
    by = valueLike(text.at(*at), wanted, quantity::length);
  }
  if (at) {
    text.replace(*at, by);
  } else {
    text.addEntry(entry, behind, key, by);
  }
}

void writeAttached(const YAML::Node& entry, bool loaded, bool wanted, YamlText& text) {
  if (wanted == loaded) return;
  const std::string by = wanted ? "true" : "false";
  if (const auto at = text.valueOf(entry, "attached")) {
    text.replace(*at, by);
  } else {
    text.addEntry(entry, "type", "attached", by);
  }
}

std::string textOf(const Clip& clip, const ClipMount& mount, const Harness& harness) {
  return "{name: " + clip.name + ", type: " + clip.type + ", cable: " + harness.cables[clip.cable].name +
         ", at: " +
         (clip.arc_length >= harness.cables[clip.cable].length ? "end" : lengthText(clip.arc_length)) +
         (mount.component == "world" ? "" : ", component: " + mount.component) +
         ", pose: " + poseText(mount.pose) + (clip.attached ? "" : ", attached: false") + "}";
}

void writeClips(const YAML::Node& root, const Scene& loaded, const Scene& wanted, YamlText& text) {
  const std::size_t known = loaded.harness.clips.size();
  for (std::size_t i = 0; i < known; ++i) {
    const YAML::Node entry = root["clips"][i];
    const Clip& clip = wanted.harness.clips[i];
    writePlace(entry, "at", loaded.harness.clips[i].arc_length, clip.arc_length,
               wanted.harness.cables[clip.cable], "name", text);
    writePose(entry, loaded.clip_mounts[i].pose, wanted.clip_mounts[i].pose, text);
    writeAttached(entry, loaded.harness.clips[i].attached, clip.attached, text);
  }
  std::vector<std::string> added;
  for (std::size_t i = known; i < wanted.harness.clips.size(); ++i)
    added.push_back(textOf(wanted.harness.clips[i], wanted.clip_mounts[i], wanted.harness));
  text.addItems(root, "clips", added);
}

void writeCables(const YAML::Node& root, const Harness& loaded, const Harness& wanted, YamlText& text) {
  const std::size_t known = loaded.cables.size();
  for (std::size_t i = 0; i < known; ++i)
    writeCable(root["cables"][i], loaded.cables[i], wanted.cables[i], text);
  std::vector<std::string> added;
  for (std::size_t i = known; i < wanted.cables.size(); ++i) added.push_back(cableText(wanted.cables[i]));
  text.addItems(root, "cables", added);
}

void writeJoints(const YAML::Node& list, const Harness& loaded, const Harness& wanted, YamlText& text) {
  for (std::size_t i = 0; i < wanted.joints.size(); ++i) {
    const Joint& before = loaded.joints[i];
    const Joint& joint = wanted.joints[i];
    writePlace(list[i], "at", before.parent_arc_length, joint.parent_arc_length, wanted.cables[joint.parent],
               "name", text);
    writePlace(list[i], "child_at", before.child_arc_length, joint.child_arc_length,
               wanted.cables[joint.child], "child", text);
  }
}

// Loads of free clips stand before those of the list, and go with their clips.
void writeLoads(const YAML::Node& list, const Harness& loaded, const Harness& wanted, YamlText& text) {
  const std::size_t first = wanted.loads.size() - list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const PointLoad& load = wanted.loads[first + i];
    writePlace(list[i], "at", loaded.loads[first + i].arc_length, load.arc_length, wanted.cables[load.cable],
               "name", text);
  }
}

/// Compares numbers of two scenes, and throws with the name of the first that differs.
class Comparison {
 public:
  void number(const std::string& what, double saved, double wanted, double tolerance) const {
    if (std::abs(saved - wanted) <= tolerance) return;
    throw std::invalid_argument(what + " would be " + shortNumber(saved) + " in the file, expected " +
                                shortNumber(wanted) +
                                "; if it is shared by an alias, give it a value of its own");
  }
  void length(const std::string& what, double saved, double wanted) const {
    number(what, saved, wanted, 1e-8);
  }
  void share(const std::string& what, double saved, double wanted) const {
    number(what, saved, wanted, 1e-9 * std::abs(wanted));
  }
  void pose(const std::string& what, const Pose& saved, const Pose& wanted) const {
    for (int i = 0; i < 3; ++i) length(what + ": position", saved.position[i], wanted.position[i]);
    number(what + ": angle to what it is", turnBetween(saved, wanted), 0.0, 1e-8);
  }
};

void requireSame(const Cable& saved, const Cable& wanted, const Comparison& compare) {
  const std::string who = "cable '" + wanted.name + "'";
  compare.length(who + ": length", saved.length, wanted.length);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Section a = sectionAt(saved, share * saved.length), b = sectionAt(wanted, share * wanted.length);
    compare.share(who + ": radius", a.radius, b.radius);
    compare.share(who + ": width", a.width, b.width);
    compare.share(who + ": EA", a.EA, b.EA);
    compare.share(who + ": GA", a.GA_y, b.GA_y);
    compare.share(who + ": GA", a.GA_z, b.GA_z);
    compare.share(who + ": EI", a.EI_y, b.EI_y);
    compare.share(who + ": EI", a.EI_z, b.EI_z);
    compare.share(who + ": GJ", a.GJ, b.GJ);
    compare.share(who + ": mass per length", a.mass_per_length, b.mass_per_length);
  }
  compare.number(who + ": number of places with a rest curvature",
                 static_cast<double>(saved.rest_curvature.size()),
                 static_cast<double>(wanted.rest_curvature.size()), 0.0);
  for (std::size_t i = 0; i < wanted.rest_curvature.size(); ++i) {
    const RestCurvatureAt& a = saved.rest_curvature[i];
    const RestCurvatureAt& b = wanted.rest_curvature[i];
    compare.length(who + ": place of a rest curvature", a.arc_length, b.arc_length);
    compare.number(who + ": rest curvature", (a.curvature - b.curvature).norm(), 0.0, 1e-8);
  }
}

}  // namespace

std::string editedSceneText(const std::string& text, const Scene& loaded, const Scene& wanted) {
  const std::string mark = "\xef\xbb\xbf";  // of byte order
  const bool marked = text.compare(0, mark.size(), mark) == 0;
  FaultList faults(wanted.source);
  const YAML::Node root = readYamlDocument(text, faults);
  if (!root.IsMap()) throw std::invalid_argument("'" + wanted.source + "' is no scene file");
  YamlText edited(marked ? text.substr(mark.size()) : text);
  for (std::size_t i = 0; i < wanted.components.size(); ++i) {
    writePose(root["components"][i], loaded.components[i].pose, wanted.components[i].pose, edited);
  }
  writeCables(root, loaded.harness, wanted.harness, edited);
  writeClips(root, loaded, wanted, edited);
  writeJoints(root["joints"], loaded.harness, wanted.harness, edited);
  if (root["loads"]) writeLoads(root["loads"], loaded.harness, wanted.harness, edited);
  return (marked ? mark : std::string()) + edited.edited();
}

void requireSame(const Scene& saved, const Scene& wanted) {
  const Comparison compare;
  const auto count = [&](const char* what, std::size_t a, std::size_t b) {
    compare.number(std::string("number of ") + what, static_cast<double>(a), static_cast<double>(b), 0.0);
  };
  count("components", saved.components.size(), wanted.components.size());
  count("cables", saved.harness.cables.size(), wanted.harness.cables.size());
  count("clips", saved.harness.clips.size(), wanted.harness.clips.size());
  count("contacts", saved.harness.contacts.size(), wanted.harness.contacts.size());
  for (std::size_t i = 0; i < wanted.harness.contacts.size(); ++i) {
    const PartContact &a = saved.harness.contacts[i], &b = wanted.harness.contacts[i];
    const std::string who = "contact with '" + b.part + "'";
    compare.length(who + ": stand-off", a.stand_off, b.stand_off);
    compare.length(who + ": skipped near clips", a.skip_near_clips, b.skip_near_clips);
  }
  for (std::size_t i = 0; i < wanted.components.size(); ++i) {
    compare.pose("component '" + wanted.components[i].name + "'", saved.components[i].pose,
                 wanted.components[i].pose);
  }
  for (std::size_t i = 0; i < wanted.harness.cables.size(); ++i)
    requireSame(saved.harness.cables[i], wanted.harness.cables[i], compare);
  for (std::size_t i = 0; i < wanted.harness.clips.size(); ++i) {
    const Clip& clip = wanted.harness.clips[i];
    const std::string who = "clip '" + clip.name + "'";
    compare.length(who + ": arc length", saved.harness.clips[i].arc_length, clip.arc_length);
    compare.number(who + ": attached", saved.harness.clips[i].attached, clip.attached, 0.0);
    if (isMounted(clip)) compare.pose(who, saved.clip_mounts[i].pose, wanted.clip_mounts[i].pose);
  }
  for (std::size_t i = 0; i < wanted.design_variables.size(); ++i) {
    const auto* property = std::get_if<CableProperty>(&wanted.design_variables[i].target);
    if (property == nullptr || property->property != CableProperty::Property::radius) continue;
    if (std::get<CableProperty>(saved.design_variables[i].target).similar == property->similar) continue;
    throw std::invalid_argument(
        "design variable '" + wanted.design_variables[i].name +
        "' scales a section by its geometry, which cannot have the stiffness that the "
        "design has; expected EI, GJ, EA and density at their nominal values");
  }
  for (std::size_t i = 0; i < wanted.harness.joints.size(); ++i) {
    const Joint& joint = wanted.harness.joints[i];
    const std::string who = "joint '" + joint.name + "'";
    compare.length(who + ": at", saved.harness.joints[i].parent_arc_length, joint.parent_arc_length);
    compare.length(who + ": child_at", saved.harness.joints[i].child_arc_length, joint.child_arc_length);
  }
  for (std::size_t i = 0; i < wanted.harness.loads.size(); ++i) {
    compare.length("load '" + wanted.harness.loads[i].name + "': at", saved.harness.loads[i].arc_length,
                   wanted.harness.loads[i].arc_length);
  }
}

}  // namespace cable_variation
