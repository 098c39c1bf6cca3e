#pragma once

#include <cstdint>
#include <string>

namespace cable_variation {

constexpr std::uintmax_t kAnySize = static_cast<std::uintmax_t>(-1);

/// Why a file cannot be read whole without waiting: "does not exist", "is a folder",
/// "is a named pipe", "has 3 GB; expected at most 1 GB". Empty: it can.
std::string obstacleTo(const std::string& path, std::uintmax_t most_bytes);

/// The contents of a regular file of at most `most_bytes`. Throws std::invalid_argument with what
/// obstacleTo() says.
std::string readWhole(const std::string& path, std::uintmax_t most_bytes);

}  // namespace cable_variation
