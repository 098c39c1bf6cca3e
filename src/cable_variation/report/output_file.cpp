#include <cable_variation/report/output_file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <unistd.h>

namespace cable_variation {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error("file '" + path + "' cannot be written: " + std::strerror(error));
}

}  // namespace

void writeFile(const std::string& path, const std::string& contents) {
  // Of its own for each process, since several may write one report.
  const std::string temporary = path + "." + std::to_string(::getpid()) + ".part";
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) fail(path, errno);
  int error = 0;
  if (std::fwrite(contents.data(), 1, contents.size(), file) != contents.size()) error = errno;
  if (error == 0 && (std::fflush(file) != 0 || ::fsync(::fileno(file)) != 0)) error = errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    std::remove(temporary.c_str());
    fail(path, error);
  }
}

}  // namespace cable_variation
