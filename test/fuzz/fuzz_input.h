#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace cable_variation {

/// A file in memory that has these bytes and lives as long as this.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : file_(memfd_create("fuzz", 0)) {
    if (file_ < 0 || write(file_, data, size) != static_cast<ssize_t>(size)) {
      throw std::runtime_error("no file in memory");
    }
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

/// Does something with an input, which may be refused with a message. All else that is thrown, or a refusal
/// without a word, ends the fuzzer.
template <typename Work>
int acceptsOrRefuses(const Work& work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    if (*error.what() == '\0') throw std::logic_error("a refusal without a message");
  }
  return 0;
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) {
  return std::string(reinterpret_cast<const char*>(data), size);
}

}  // namespace cable_variation
