#pragma once

#include <string>

namespace cable_variation_ros {

/// cable_variation below ROS's own folder for what running nodes write: $ROS_HOME,
/// else ~/.ros, else the working directory.
std::string defaultOutputDirectory();

/// The only folder that files are written to, whatever a request asks for.
class OutputDirectory {
 public:
  /// A path; relative ones start at the working directory. Nothing is made yet.
  explicit OutputDirectory(const std::string& path);

  /// Throws std::invalid_argument unless `name` can name a file in any folder and
  /// nothing outside it: letters, digits, _ - and . (not first), at most 100.
  static void checkName(const std::string& name);

  /// The path of the file `name` + `extension` in the folder, which is made if it
  /// is not there. Throws checkName()'s, and std::runtime_error that names the
  /// folder if it cannot be made.
  std::string fileFor(const std::string& name, const std::string& extension) const;

 private:
  std::string path_;
};

}  // namespace cable_variation_ros
