#include <cable_variation/scene/package_finder.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

#include <tinyxml2.h>

namespace cable_variation {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 6;  // below a folder of the package path: a stack in a source space, and some more

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// Of a folder's package.xml; empty: there is none that can be read.
std::string packageIn(const fs::path& folder) {
  constexpr std::uintmax_t kLargest = 1'000'000;  // [B]
  const fs::path file = folder / "package.xml";
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kLargest || error) return "";
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) return "";
  const tinyxml2::XMLElement* root = document.FirstChildElement("package");
  const tinyxml2::XMLElement* name = root == nullptr ? nullptr : root->FirstChildElement("name");
  const char* text = name == nullptr ? nullptr : name->GetText();
  if (text == nullptr) return "";
  std::string word;
  std::istringstream(text) >> word;
  return word;
}

/// The package in a folder or below it, but not in another package or a folder that is to be ignored.
fs::path below(const fs::path& folder, const std::string& package, int depth) {
  if (isThere(folder / "CATKIN_IGNORE") || isThere(folder / "rospack_nosubdirs")) return {};
  if (isThere(folder / "package.xml")) return packageIn(folder) == package ? folder : fs::path();
  if (depth == 0) return {};
  std::error_code error;
  for (fs::directory_iterator each(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && each != end; each.increment(error)) {
    std::error_code ignored;
    if (!each->is_directory(ignored) || each->path().filename().string().front() == '.') continue;
    fs::path found = below(each->path(), package, depth - 1);
    if (!found.empty()) return found;
  }
  return {};
}

std::vector<fs::path> packagePath() {
  std::vector<fs::path> folders;
  const char* variable = std::getenv("ROS_PACKAGE_PATH");
  std::istringstream text(variable == nullptr ? "" : variable);
  for (std::string folder; std::getline(text, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

/// A folder, and all around it.
fs::path around(fs::path folder, const std::string& package) {
  for (;;) {
    if (packageIn(folder) == package) return folder;
    if (!folder.has_relative_path()) return {};
    folder = folder.parent_path();
  }
}

}  // namespace

std::string findPackageNear(const std::string& package, const std::string& near) {
  for (const fs::path& folder : packagePath()) {
    if (packageIn(folder / package) == package) return folder / package;
  }
  for (const fs::path& folder : packagePath()) {
    const fs::path found = below(folder, package, kDeepest);
    if (!found.empty()) return found;
  }
  std::error_code error;
  const fs::path there = fs::absolute(near, error);
  // as it is named, and where its links lead: a scene may be reached through a link from outside its package
  for (const fs::path& folder : {there.lexically_normal(), fs::weakly_canonical(there, error)}) {
    const fs::path found = around(folder, package);
    if (!found.empty()) return found;
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path share = program.parent_path().parent_path().parent_path() / "share" / package;
  return !error && packageIn(share) == package ? share.string() : "";
}

}  // namespace cable_variation
