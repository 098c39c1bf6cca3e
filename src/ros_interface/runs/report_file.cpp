#include <ros_interface/runs/report_file.h>

#include <cable_variation/analysis/answer_files.h>

namespace cable_variation_ros {

std::string writeBeside(const cable_variation::OutputDirectory& output, const std::string& name,
                        const std::string& extension, const std::string& contents,
                        cable_variation::Status& status) {
  std::string path = cable_variation::writeBeside(output, name, extension, contents, status.message);
  if (path.empty()) status.code = cable_variation::Status::IO_ERROR;
  return path;
}

}  // namespace cable_variation_ros
