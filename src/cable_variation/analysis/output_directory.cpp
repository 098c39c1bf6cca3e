#include <cable_variation/analysis/output_directory.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

#include <cable_variation/util/error.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {

namespace {

constexpr std::size_t kLongestName = 100;  // leaves room for an extension in the 255 bytes file systems allow

bool canNameAFile(const std::string& name) {
  if (name.empty() || name.size() > kLongestName || name.front() == '.') return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

std::string gigabytes(double bytes) {
  constexpr double kGigabyte = 1e9;
  return numberText(bytes / kGigabyte, 3) + " GB";
}

}  // namespace

OutputDirectory::OutputDirectory(const std::string& path) : path_(std::filesystem::absolute(path)) {}

void OutputDirectory::checkName(const std::string& name) {
  if (canNameAFile(name)) return;
  throw std::invalid_argument("file name '" + name +
                              "': expected letters, digits, _ - and . (not first), 1 to " +
                              std::to_string(kLongestName) + " of them");
}

std::string OutputDirectory::pathOf(const std::string& name, const std::string& extension) const {
  checkName(name);
  return std::filesystem::path(path_) / (name + extension);
}

void OutputDirectory::make() const {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw FileError("folder '" + path_ + "' cannot be made: " + error.message());
}

std::string OutputDirectory::nearest() const {
  std::filesystem::path there = path_;
  std::error_code error;
  while (!std::filesystem::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  return there;
}

void OutputDirectory::requireWritable() const {
  const std::string there = nearest();
  std::error_code error;
  const std::string folder = "folder '" + path_ + "' cannot be " + (there == path_ ? "written to" : "made");
  if (!std::filesystem::is_directory(there, error))
    throw FileError(folder + ": '" + there + "' is no folder");
  if (::access(there.c_str(), W_OK | X_OK) != 0)
    throw FileError(folder + ": " + std::generic_category().message(errno));
}

void OutputDirectory::requireSpace(double bytes) const {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(nearest(), error);
  if (error || static_cast<double>(space.available) >= bytes) return;
  throw FileError("folder '" + path_ + "' has " + gigabytes(static_cast<double>(space.available)) +
                  " free, what is to be written there takes about " + gigabytes(bytes));
}

std::string OutputDirectory::fileFor(const std::string& name, const std::string& extension) const {
  std::string file = pathOf(name, extension);
  make();
  return file;
}

}  // namespace cable_variation
