#include <ros_interface/services/save_scene_service.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <ros/node_handle.h>

#include <cable_variation/equilibrium/shape_distance.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/scene_writer.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>
#include <cable_variation/util/quantity.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/same_poses.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::Scene;

namespace {

const std::string kExtension = ".yaml";

std::string withoutExtension(std::string name) {
  const std::size_t size = kExtension.size();
  if (name.size() > size && name.compare(name.size() - size, size, kExtension) == 0)
    name.resize(name.size() - size);
  return name;
}

/// A motion's file has the poses of its component, whatever the scene file says.
std::vector<std::string> warningsOfMotions(const Scene& loaded, const Scene& saved) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < loaded.components.size(); ++i) {
    const std::string& name = loaded.components[i].name;
    const bool moved =
        std::any_of(loaded.motions.begin(), loaded.motions.end(),
                    [&](const cable_variation::Motion& motion) { return motion.component == name; });
    if (!moved || same(loaded.components[i].pose, saved.components[i].pose)) continue;
    warnings.push_back("component '" + name +
                       "' is at its new pose while nothing moves it; the motion that it has is as it was");
  }
  return warnings;
}

/// A scene is solved from nothing, which need not lead to the shape that the design was followed to.
std::string warningOfShape(const SolverContext& context) {
  constexpr double kNoticed = 1e-3;    // [m]
  constexpr std::size_t kPlaces = 50;  // of a cable
  if (context.harness().cables.empty()) return "";
  try {
    const cable_variation::ComponentPoses at_rest = placesOf(context.design(), {});
    const double distance = shapeDistance(context.solve({}, at_rest, true).equilibrium.shapes,
                                          context.solve({}, at_rest, false).equilibrium.shapes, kPlaces)
                                .distance;
    if (distance < kNoticed) return "";
    return "when it is loaded, the cables take a shape of lower energy than the one in force, up to " +
           cable_variation::shortNumber(1e3 * distance) + " mm away from it";
  } catch (const std::runtime_error& error) {
    return std::string("with its components where the scene has them there is no equilibrium: ") +
           error.what();
  }
}

}  // namespace

SaveSceneService::SaveSceneService(ros::NodeHandle& node, SolverContext& context,
                                   cable_variation::OutputDirectory output, NameRegistry& names)
    : context_(context),
      output_(std::move(output)),
      names_(names),
      server_(node.advertiseService(kSaveSceneService, &SaveSceneService::handle, this)) {}

bool SaveSceneService::handle(cable_variation::SaveSceneRequest& request,
                              cable_variation::SaveSceneResponse& response) {
  response.status = runRequest([&] { save(request, response); });
  return true;
}

void SaveSceneService::save(const cable_variation::SaveSceneRequest& request,
                            cable_variation::SaveSceneResponse& response) {
  const std::string name = withoutExtension(request.name);
  const std::string path = output_.pathOf(name, kExtension);
  const NameRegistry::Hold hold(names_, "name", name, kSaveSceneService);
  std::error_code ignored;
  if (!request.overwrite && std::filesystem::exists(path, ignored)) {
    throw std::invalid_argument("name '" + name + "': there is a file '" + path +
                                "' already; expected another name, or overwrite");
  }
  const Scene& loaded = context_.loaded();
  const Scene wanted = sceneOf(context_.design());
  const std::string text = editedSceneText(context_.loadedText(), loaded, wanted);
  requireSame(cable_variation::readSceneText(text, path, findPackage, context_.limits()), wanted);
  response.warnings = warningsOfMotions(loaded, wanted);
  const std::string shape = warningOfShape(context_);
  if (!shape.empty()) response.warnings.push_back(shape);
  output_.make();
  cable_variation::writeFile(path, text);
  response.file = path;
}

}  // namespace cable_variation_ros
