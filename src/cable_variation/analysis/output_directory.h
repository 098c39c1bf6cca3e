#pragma once

#include <string>

namespace cable_variation {

/// The only folder that files are written to, whatever a request asks for.
class OutputDirectory {
 public:
  /// A path; relative ones start at the working directory. Nothing is made yet.
  explicit OutputDirectory(const std::string& path);

  /// Throws std::invalid_argument unless `name` can name a file in any folder and
  /// nothing outside it: letters, digits, _ - and . (not first), at most 100.
  static void checkName(const std::string& name);

  /// The path of the file `name` + `extension` in the folder, there or not. Throws checkName()'s.
  std::string pathOf(const std::string& name, const std::string& extension) const;

  /// Makes the folder if it is not there. Throws FileError that names it if it cannot be
  /// made.
  void make() const;

  /// Whether files can be written there, as far as that can be told before one is; makes nothing. Throws
  /// FileError that names the folder and what is wrong.
  void requireWritable() const;

  /// Likewise whether so many bytes have room there. Throws FileError that names the folder, what is free and
  /// what is not.
  void requireSpace(double bytes) const;

  /// pathOf() in a folder that is there. Throws as both.
  std::string fileFor(const std::string& name, const std::string& extension) const;

 private:
  std::string nearest() const;  // the folder, or what is there of the way to it

  std::string path_;
};

}  // namespace cable_variation
