#include <cable_variation/util/regular_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

std::string sizeText(std::uintmax_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size >= 1e9) return shortNumber(size * 1e-9) + " GB";
  if (size >= 1e6) return shortNumber(size * 1e-6) + " MB";
  return shortNumber(size * 1e-3) + " kB";
}

}  // namespace

std::string obstacleTo(const std::string& path, std::uintmax_t most_bytes) {
  using std::filesystem::file_type;
  std::error_code error;
  switch (std::filesystem::status(path, error).type()) {
    case file_type::regular:
      break;
    case file_type::directory:
      return "is a folder; expected a file";
    case file_type::fifo:
      return "is a named pipe; expected a file";
    case file_type::block:
    case file_type::character:
      return "is a device; expected a file";
    case file_type::socket:
      return "is a socket; expected a file";
    case file_type::none:
    case file_type::not_found:
    case file_type::symlink:
    case file_type::unknown:
      return "does not exist";
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > most_bytes) {
    return "has " + sizeText(size) + "; expected at most " + sizeText(most_bytes);
  }
  return std::ifstream(path, std::ios::binary) ? "" : "cannot be read";
}

std::string readWhole(const std::string& path, std::uintmax_t most_bytes) {
  const std::string obstacle = obstacleTo(path, most_bytes);
  if (!obstacle.empty()) throw std::invalid_argument(obstacle);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw std::invalid_argument("cannot be read");
  return text.str();
}

}  // namespace cable_variation
