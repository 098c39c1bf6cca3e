#include <cable_variation/util/regular_file.h>

#include <cerrno>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

std::string sizeText(std::uintmax_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size >= 1e9) return shortNumber(size * 1e-9) + " GB";
  if (size >= 1e6) return shortNumber(size * 1e-6) + " MB";
  return shortNumber(size * 1e-3) + " kB";
}

std::string tooLarge(std::uintmax_t size, std::uintmax_t most_bytes) {
  return "has " + sizeText(size) + "; expected at most " + sizeText(most_bytes);
}

std::string obstacleOf(const struct stat& file, std::uintmax_t most_bytes) {
  if (S_ISDIR(file.st_mode)) return "is a folder; expected a file";
  if (S_ISFIFO(file.st_mode)) return "is a named pipe; expected a file";
  if (S_ISBLK(file.st_mode) || S_ISCHR(file.st_mode)) return "is a device; expected a file";
  if (S_ISSOCK(file.st_mode)) return "is a socket; expected a file";
  if (S_ISLNK(file.st_mode)) return "is a link; expected a file";
  if (!S_ISREG(file.st_mode)) return "is no file";
  const auto size = static_cast<std::uintmax_t>(file.st_size);
  return size > most_bytes ? tooLarge(size, most_bytes) : "";
}

// Asked before it is opened, for opening a device may do something.
std::string obstacleAt(const std::string& path, std::uintmax_t most_bytes, bool follow) {
  if (path.find('\0') != std::string::npos) return "has a byte 0 in its name; expected a file";
  struct stat file {};
  const int failed = follow ? ::stat(path.c_str(), &file) : ::lstat(path.c_str(), &file);
  if (failed != 0) return errno == EACCES ? "cannot be read" : "does not exist";
  return obstacleOf(file, most_bytes);
}

// Does not wait for a pipe that came into its place.
int opened(const std::string& path, bool follow) {
  return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (follow ? 0 : O_NOFOLLOW));
}

}  // namespace

std::string obstacleTo(const std::string& path, std::uintmax_t most_bytes) {
  try {
    const RegularFile file(path, most_bytes);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

RegularFile::RegularFile(const std::string& path, std::uintmax_t most_bytes, Links links)
    : left_(most_bytes) {
  const bool follow = links == Links::follow;
  std::string obstacle = obstacleAt(path, most_bytes, follow);
  if (obstacle.empty()) {
    file_ = opened(path, follow);
    struct stat file {};
    if (file_ < 0 || ::fstat(file_, &file) != 0) {
      obstacle = "cannot be read";
    } else {
      obstacle = obstacleOf(file, most_bytes);
      size_ = static_cast<std::uintmax_t>(file.st_size);
    }
  }
  if (obstacle.empty()) return;
  if (file_ >= 0) ::close(file_);
  throw std::invalid_argument(obstacle);
}

RegularFile::~RegularFile() {
  if (file_ >= 0) ::close(file_);
}

std::size_t RegularFile::read(char* to, std::size_t count) {
  for (;;) {
    const ssize_t some = ::read(file_, to, count);
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) throw std::invalid_argument("cannot be read");
    const auto bytes = static_cast<std::uintmax_t>(some);
    if (bytes > left_) throw std::invalid_argument("grows while it is read");
    left_ -= bytes;
    return static_cast<std::size_t>(bytes);
  }
}

std::string readWhole(const std::string& path, std::uintmax_t most_bytes, RegularFile::Links links) {
  constexpr std::size_t kPiece = std::size_t{1} << 16U;
  RegularFile file(path, most_bytes, links);
  std::string text;
  text.reserve(static_cast<std::size_t>(file.size()) + kPiece);
  for (std::size_t done = 0;;) {
    text.resize(done + kPiece);
    const std::size_t some = file.read(&text[done], kPiece);
    done += some;
    if (some > 0) continue;
    text.resize(done);
    return text;
  }
}

}  // namespace cable_variation
