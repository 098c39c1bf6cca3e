#include <cable_variation/scene/resource_address.h>

#include <filesystem>
#include <stdexcept>

namespace cable_variation {

std::string localPath(const std::string& address, const PackageFinder& find_package) {
  const std::string package_scheme = "package://";
  const std::string file_scheme = "file://";
  std::string path;
  if (address.compare(0, package_scheme.size(), package_scheme) == 0) {
    const std::size_t slash = address.find('/', package_scheme.size());
    const std::string package = address.substr(package_scheme.size(), slash - package_scheme.size());
    if (package.empty() || slash == std::string::npos) {
      throw std::invalid_argument("'" + address + "' is incomplete; expected package://NAME/PATH");
    }
    const std::string folder = find_package ? find_package(package) : std::string();
    if (folder.empty())
      throw std::invalid_argument("package '" + package + "' of '" + address + "' was not found");
    path = folder + address.substr(slash);
  } else if (address.compare(0, file_scheme.size(), file_scheme) == 0) {
    path = address.substr(file_scheme.size());
    if (path.empty() || path.front() != '/') {
      throw std::invalid_argument("'" + address + "' is no absolute path; expected file:///PATH");
    }
  } else {
    throw std::invalid_argument("found '" + address +
                                "'; expected an address that starts with package:// or file://");
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw std::invalid_argument(
        "'" + address + "' does not exist" +
        (path == address.substr(file_scheme.size()) ? "" : " (looked for " + path + ")"));
  }
  return path;
}

}  // namespace cable_variation
