#include <cable_variation/scene/resource_address.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>

#include <cable_variation/util/name_list.h>

namespace cable_variation {
namespace {

const std::string kPackageScheme = "package://";
const std::string kFileScheme = "file://";

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// %XX as the byte that it stands for; none if one of them is no escape, or that of the byte 0.
std::optional<std::string> unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    if (low < 0 || high * 16 + low == 0) return {};
    result += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return result;
}

std::string escaped(const std::string& path) {
  const std::string hex = "0123456789ABCDEF";
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain =
        byte < 0x80 && (std::isalnum(byte) != 0 || std::string("/-_.~+,@").find(c) != std::string::npos);
    if (plain) {
      result += c;
    } else {
      result += {'%', hex[byte / 16], hex[byte % 16]};
    }
  }
  return result;
}

// The place that an address names: a package and its folder (or none, of file://), and the path below.
struct Place {
  std::string package;
  std::string folder;
  std::string below;  // starts with /
};

Place placeOf(const std::string& address, const PackageFinder& find_package) {
  Place place;
  if (startsWith(address, kPackageScheme)) {
    const std::size_t slash = std::min(address.find('/', kPackageScheme.size()), address.size());
    place.package = address.substr(kPackageScheme.size(), slash - kPackageScheme.size());
    place.below = address.substr(slash);
    if (place.package.empty() || place.below.size() < 2) {
      throw std::invalid_argument("'" + address + "' is incomplete; expected package://NAME/PATH");
    }
    if (find_package) place.folder = find_package(place.package);
    if (place.folder.empty()) {
      throw std::invalid_argument("package '" + place.package + "' of '" + address + "' was not found");
    }
  } else if (startsWith(address, kFileScheme)) {
    place.below = address.substr(kFileScheme.size());
    if (place.below.empty() || place.below.front() != '/') {
      throw std::invalid_argument("'" + address + "' is no absolute path; expected file:///PATH");
    }
  } else {
    throw std::invalid_argument("found '" + address +
                                "'; expected an address that starts with package:// or file://");
  }
  return place;
}

std::string normal(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

std::string urlOf(const Place& place, const std::string& path) {
  const std::string start = normal(place.folder + "/");
  const bool in_package = !place.package.empty() && startsWith(path, start);
  return in_package && escaped(place.folder) == place.folder
             ? kPackageScheme + place.package + "/" + escaped(path.substr(start.size()))
             : fileUrl(path);
}

}  // namespace

ResourceFile findResource(const std::string& address, const PackageFinder& find_package,
                          std::uintmax_t most_bytes, const std::vector<std::string>& folders) {
  const Place place = placeOf(address, find_package);
  const auto pathOf = [&](const std::string& below) { return normal(place.folder + below); };
  const auto isThere = [](const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
  };
  const auto decoded = unescaped(place.below);
  const bool as_url = decoded && isThere(pathOf(*decoded));
  const std::string path = pathOf(as_url ? *decoded : place.below);
  requireWithin(path, folders);
  const std::string obstacle = obstacleTo(path, most_bytes);
  if (!obstacle.empty()) {
    throw std::invalid_argument("'" + address + "' " + obstacle +
                                (kFileScheme + path == address ? "" : " (looked for " + path + ")"));
  }
  return {path, urlOf(place, path)};
}

std::string localPath(const std::string& address, const PackageFinder& find_package,
                      std::uintmax_t most_bytes, const std::vector<std::string>& folders) {
  return findResource(address, find_package, most_bytes, folders).path;
}

void requireWithin(const std::string& path, const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  if (folders.empty()) return;
  const auto real = [](const std::string& of) {
    std::error_code error;
    const fs::path found = fs::weakly_canonical(fs::absolute(of, error), error);
    return error ? fs::path() : found;
  };
  const fs::path file = real(path);
  for (const std::string& folder : folders) {
    const fs::path root = real(folder);
    if (root.empty() || file.empty()) continue;
    const auto ends = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (ends.first == root.end() || (ends.first->empty() && std::next(ends.first) == root.end())) return;
  }
  throw std::invalid_argument("'" + path +
                              "' is not within the folders that files may be read from: " + joined(folders));
}

std::string fileUrl(const std::string& path) { return kFileScheme + escaped(path); }

std::string extensionOf(const std::string& address) {
  std::string extension = std::filesystem::path(address).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace cable_variation
