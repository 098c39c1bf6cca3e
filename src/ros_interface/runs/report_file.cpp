#include <ros_interface/runs/report_file.h>

#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/conversion/utc_time.h>

namespace cable_variation_ros {

using cable_variation::Review;
using cable_variation::Scene;
using cable_variation::Status;

Review startReview(const std::string& title, const DesignOrigin& origin, const Scene& scene,
                   const cable_variation::DesignValues& values, const cable_variation::SolvedScene& solved) {
  return {title,
          utcNow(),
          origin.author,
          {},
          warningsOf(scene),
          origin.source_hash,
          origin.changes,
          scene,
          values,
          solved,
          {},
          {},
          {},
          nullptr,
          nullptr,
          std::nullopt,
          std::nullopt};
}

std::string motionText(const Scene& scene, const std::vector<std::size_t>& motions) {
  std::string text;
  for (const std::size_t index : motions) text += (text.empty() ? "" : " and ") + scene.motions[index].name;
  return text;
}

std::string writeBeside(const OutputDirectory& output, const std::string& name, const std::string& extension,
                        const std::string& contents, Status& status) {
  const std::string path = output.pathOf(name, extension);
  try {
    output.make();
    cable_variation::writeFile(path, contents);
    return path;
  } catch (const cable_variation::FileError& problem) {
    status.code = Status::IO_ERROR;
    if (status.message.find(problem.what()) == std::string::npos)  // a folder that is not there is told once
      status.message += (status.message.empty() ? "" : "; ") + std::string(problem.what());
    return "";
  }
}

}  // namespace cable_variation_ros
