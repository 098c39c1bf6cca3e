#include <cable_variation/geometry/mesh/stl_reader.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/mesh/soup_builder.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes

std::uint32_t littleEndian32(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
  return value;
}

TriangleMesh readBinary(std::string_view file, std::uint32_t facets, std::size_t most_triangles) {
  SoupBuilder builder(most_triangles);
  for (std::size_t i = 0; i < facets; ++i) {
    const char* bytes = file.data() + kHeader + i * kFacet + 12;  // behind the normal
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3d at;
      for (int axis = 0; axis < 3; ++axis, bytes += 4) {
        const std::uint32_t bits = littleEndian32(bytes);
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof value);
        at[axis] = static_cast<double>(value);
      }
      if (!at.allFinite()) {
        throw std::invalid_argument("a vertex of facet " + std::to_string(i + 1) + " is not finite");
      }
      corners.push_back(builder.vertex(at));
    }
    builder.polygon(corners);
  }
  return builder.take();
}

class TextReader {
 public:
  TextReader(std::string_view file, std::size_t most_triangles) : words_(file), builder_(most_triangles) {}

  TriangleMesh read() {
    while (!words_.atEnd()) {
      expect("solid");
      words_.skipLine();  // its name
      for (std::string word = wordBefore("facet or endsolid"); word != "endsolid";
           word = wordBefore("facet or endsolid")) {
        if (word != "facet") fail("found " + quoted(word) + "; expected facet or endsolid");
        facet();
      }
      words_.skipLine();
    }
    return builder_.take();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("line " + std::to_string(words_.line()) + ": " + what);
  }
  std::string wordBefore(const std::string& expected) {
    const auto word = words_.next();
    if (!word) fail("the file is cut off; expected " + expected);
    return lowerCase(*word);
  }
  void expect(const std::string& expected) {
    const std::string word = wordBefore(expected);
    if (word != expected) fail("found " + quoted(word) + "; expected " + expected);
  }
  void facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) wordBefore("a normal");
    expect("outer");
    expect("loop");
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      Vector3d at;
      for (int axis = 0; axis < 3; ++axis) {
        const std::string word = wordBefore("a coordinate");
        const auto number = numberIn(word);
        if (!number) fail("found " + quoted(word) + "; expected a coordinate, a finite number");
        at[axis] = *number;
      }
      corners.push_back(builder_.vertex(at));
    }
    expect("endloop");
    expect("endfacet");
    builder_.polygon(corners);
  }

  TextTokens words_;
  SoupBuilder builder_;
};

}  // namespace

TriangleMesh readStl(std::string_view file, std::size_t most_triangles) {
  if (file.size() >= kHeader) {
    const std::uint32_t facets = littleEndian32(file.data() + 80);
    if (facets <= (file.size() - kHeader) / kFacet) return readBinary(file, facets, most_triangles);
  }
  TextTokens words(file);
  const auto first = words.next();
  if (first && lowerCase(*first) == "solid" && file.find('\0') == std::string_view::npos) {
    return TextReader(file, most_triangles).read();
  }
  if (file.size() < kHeader) {
    throw std::invalid_argument("not readable as stl: it begins with " + quoted(first.value_or("")) +
                                "; expected a text that begins with solid, or 84 bytes and more");
  }
  const std::size_t facets = littleEndian32(file.data() + 80);
  throw std::invalid_argument(
      "not readable as stl: neither a text that begins with solid, nor is there room for the " +
      std::to_string(facets) + " facets of 50 bytes that it announces; it has " +
      std::to_string(file.size()) + " bytes, expected " + std::to_string(kHeader + facets * kFacet) +
      ": cut off?");
}

}  // namespace cable_variation
