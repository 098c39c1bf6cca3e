#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// A file that is there complete or not at all: written and brought to the disk under a name of its own in
/// the same folder, whoever else writes there, and given its name at once when that is wanted. Several can be
/// made ready before the first of them takes the place of an older one.
class StagedFile {
 public:
  /// Throws FileError that names the file and what the system says; then nothing is left of it.
  StagedFile(std::string path, const std::string& contents);
  ~StagedFile();  ///< takes it away, unless it got its name
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  const std::string& path() const { return path_; }

  /// Gives files their names, in their order and in place of older ones. Throws as the constructor; those
  /// before have their names then. @param files of one folder
  static void commit(std::vector<StagedFile>& files);

 private:
  std::string path_;
  std::string temporary_;  // empty: it has its name
};

/// One such file. Of several threads and processes that write the same path each leaves its own file whole;
/// the last one stays. Throws as StagedFile.
void writeFile(const std::string& path, const std::string& contents);

}  // namespace cable_variation
