#pragma once  // internal to geometry/

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cable_variation {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t sizeOf(PlyType type);  // bytes

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  ///< of a list: type of the number of its entries
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// By one of these names; none: there is none.
  std::optional<std::size_t> find(const std::vector<std::string>& names) const;
};

/// What a PLY file says of itself.
struct PlyHeader {
  enum class Format { text, little_endian, big_endian };
  Format format = Format::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes, its last line's end included
  std::size_t lines = 0;

  /// Throws std::invalid_argument with the line and what was expected.
  explicit PlyHeader(std::string_view file);
};

}  // namespace cable_variation
