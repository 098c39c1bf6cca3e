#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace cable_variation {

/// The package itself, and `test_data`: test/data.
inline std::string findTestPackage(const std::string& package) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  if (package == "cable_variation") return root;
  return package == "test_data" ? root + "/test/data" : std::string();
}

/// `text` with the package's root replaced by ROOT.
inline std::string withoutRoot(std::string text) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  for (std::size_t at = text.find(root); at != std::string::npos; at = text.find(root)) {
    text.replace(at, root.size(), "ROOT");
  }
  return text;
}

/// A text file that lives as long as this.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::vector<std::string>& lines)
      : path_(std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_" + name)) {
    std::ofstream file(path_);
    for (const std::string& line : lines) file << line << '\n';
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace cable_variation
