#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cable_variation/util/regular_file.h>

namespace cable_variation {

/// Finds the folder of a package for package:// addresses; empty: not found.
using PackageFinder = std::function<std::string(const std::string& package)>;

/// A file that a package:// or file:// address names.
struct ResourceFile {
  std::string path;  ///< local
  /// The same file as a URL whose special characters are escaped, which is how RViz reads addresses:
  /// in its package if the package's own path is plain, else by file://.
  std::string url;
};

/// Finds the file of an address. An address is a URL, as for RViz: %20 stands for a
/// blank, and .. is resolved in the text. One that names no file like that is taken
/// as it is written, so that 'my part.stl' and '50% off#2.stl' may be written plainly.
/// Throws std::invalid_argument: another scheme, no such package, not within `folders`
/// (requireWithin()), or nothing there that can be read (obstacleTo()).
ResourceFile findResource(const std::string& address, const PackageFinder& find_package,
                          std::uintmax_t most_bytes = kAnySize, const std::vector<std::string>& folders = {});

/// Its path alone.
std::string localPath(const std::string& address, const PackageFinder& find_package,
                      std::uintmax_t most_bytes = kAnySize, const std::vector<std::string>& folders = {});

/// Throws std::invalid_argument unless a path, there or not, leads into one of these folders when all links
/// are followed; nothing is told of what is there. No folders: it may lead anywhere.
void requireWithin(const std::string& path, const std::vector<std::string>& folders);

/// The file:// URL of an absolute path, with its special characters escaped.
std::string fileUrl(const std::string& path);

/// The extension of an address or path in small letters, with its dot; empty: none.
std::string extensionOf(const std::string& address);

}  // namespace cable_variation
