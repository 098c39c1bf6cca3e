#pragma once

#include <cstdint>
#include <string>

namespace cable_variation {

constexpr std::uintmax_t kAnySize = static_cast<std::uintmax_t>(-1);

/// Why a file cannot be read whole without waiting: "does not exist", "is a folder",
/// "is a named pipe", "has 3 GB; expected at most 1 GB". Empty: it can.
std::string obstacleTo(const std::string& path, std::uintmax_t most_bytes);

/// A regular file of at most so many bytes, read from its start to its end. It is asked what it is before
/// it is opened and again when it is open, so that nothing else is ever read or waited for, whoever puts
/// another thing in its place meanwhile.
class RegularFile {
 public:
  enum class Links { follow, refuse };  ///< whether its path may end in a symbolic link

  /// Throws std::invalid_argument with what obstacleTo() says, or "is a link; expected a file".
  RegularFile(const std::string& path, std::uintmax_t most_bytes, Links links = Links::follow);
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  std::uintmax_t size() const { return size_; }  ///< [B], when it was opened

  /// Up to so many more bytes; none: it has ended. Throws std::invalid_argument: it cannot be read, or it
  /// has grown beyond what is allowed.
  std::size_t read(char* to, std::size_t count);

 private:
  int file_ = -1;
  std::uintmax_t size_ = 0;
  std::uintmax_t left_;  // that may still be read
};

/// The contents of such a file. Throws as it does.
std::string readWhole(const std::string& path, std::uintmax_t most_bytes,
                      RegularFile::Links links = RegularFile::Links::follow);

}  // namespace cable_variation
