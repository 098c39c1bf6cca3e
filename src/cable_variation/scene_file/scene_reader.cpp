#include <cable_variation/scene_file/scene_reader.h>

#include <cstdint>

#include <cable_variation/scene_file/plausibility.h>
#include <cable_variation/scene_file/read_context.h>
#include <cable_variation/scene_file/yaml_document.h>
#include <cable_variation/util/regular_file.h>

namespace cable_variation {
namespace {

constexpr Range kAccuracy{1e-6, 1e-2, false};  // [m]

// The line of the thing that a harness's fault begins with: "clip 'NAME' ...".
int lineOf(const std::string& message, const ReadContext& context) {
  const std::vector<std::pair<std::string, const NameTable*>> tables{{"clip '", &context.clips},
                                                                     {"joint '", &context.joints},
                                                                     {"load '", &context.loads},
                                                                     {"cable '", &context.cables}};
  for (const auto& [start, table] : tables) {
    if (message.compare(0, start.size(), start) != 0) continue;
    const std::string name = message.substr(start.size(), message.find('\'', start.size()) - start.size());
    for (std::size_t i = 0; i < table->size(); ++i) {
      if (table->name(i) == name) return table->line(i);
    }
  }
  return 0;
}

void readParts(const YamlCursor& root, ReadContext& context) {
  if (!root.checkKeys({"gravity", "accuracy", "components", "materials", "cables", "clips", "joints", "loads",
                       "contact", "design_variables", "correlations", "measures", "motions",
                       "attachments"})) {
    return;
  }
  context.scene.harness.gravity =
      root.vector("gravity", quantity::acceleration, context.scene.harness.gravity);
  context.scene.accuracy = root.number("accuracy", quantity::length, kAccuracy, context.scene.accuracy);
  const InputLimits& limits = context.limits;
  const auto part = [&](const char* key, std::size_t most, void (*read)(const YamlCursor&, ReadContext&)) {
    const auto value = root.find(key);
    if (!value) return;
    if (!value->isAtMost(most, key)) throw FaultList::Full();  // what refers to it would be wrong too
    read(*value, context);
  };
  part("components", limits.components, readComponents);
  part("materials", limits.materials, readMaterials);
  part("cables", limits.cables, readCables);
  part("clips", limits.clips, readClips);
  part("joints", limits.joints, readJoints);
  part("loads", limits.loads, readLoads);
  part("contact", limits.contact, readContacts);
  part("design_variables", limits.design_variables, readDesignVariables);
  part("correlations", limits.correlations, readCorrelations);
  part("measures", limits.measures, readMeasures);
  part("motions", limits.motions, readMotions);
  part("attachments", limits.attachments, readAttachments);
  if (!root.has("components") && !root.has("cables"))
    root.fail("the scene has neither components nor cables");
}

// The harness as a whole, and at the limits of each design variable.
void checkHarness(ReadContext& context) {
  Scene& scene = context.scene;
  if (scene.harness.cables.empty()) return;
  for (const std::string& fault : faultsOf(scene.harness)) context.faults.add(lineOf(fault, context), fault);
  if (context.faults.count() > 0) return;
  scene.harness = harnessAt(scene, {});
  for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
    const DesignVariable& variable = scene.design_variables[i];
    for (const double deviation : {variable.lower, variable.upper}) {
      try {
        harnessAt(scene, {{variable.name, variable.nominal + deviation}});
      } catch (const std::invalid_argument& error) {
        std::string message = error.what();
        const std::string who = "design variable '" + variable.name + "': ";
        if (message.compare(0, who.size(), who) != 0) message.insert(0, who);
        context.faults.add(context.design_variables.line(i), message + " (at a limit of its tolerance)");
      }
    }
  }
}

}  // namespace

std::string readSceneFile(const std::string& path, const InputLimits& limits) {
  return readWhole(path, limits.scene_bytes);
}

Scene readScene(const std::string& path, const PackageFinder& find_package, const InputLimits& limits) {
  std::string text;
  try {
    text = readSceneFile(path, limits);
  } catch (const std::invalid_argument& error) {
    FaultList faults(path);
    faults.add(0, std::string("the file ") + error.what());
    throw SceneError(faults.sorted());
  }
  return readSceneText(text, path, find_package, limits);
}

Scene readSceneText(const std::string& text, const std::string& source, const PackageFinder& find_package,
                    const InputLimits& limits) {
  ReadContext context(source, find_package, limits);
  YAML::Node root;
  try {
    root = readYamlDocument(text, context.faults);
    if (root.IsMap()) {
      readParts(YamlCursor(root, root.Mark().line + 1, "", context.faults), context);
    } else if (context.faults.count() == 0) {
      context.faults.add(root.IsNull() ? 0 : 1,
                         "the file is no scene; expected a map with components, cables, clips");
    }
    if (context.faults.count() == 0) checkHarness(context);
  } catch (const FaultList::Full&) {
    throw SceneError(context.faults.sorted());
  }
  if (context.faults.count() > 0) throw SceneError(context.faults.sorted());
  warnOfSlips(YamlCursor(root, root.Mark().line + 1, "", context.faults), context.scene);
  context.scene.warnings = context.faults.sortedWarnings();
  return std::move(context.scene);
}

}  // namespace cable_variation
