#include <cable_variation/geometry/mesh/obj_reader.h>

#include <charconv>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/mesh/soup_builder.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view file, std::size_t most_triangles) : words_(file), builder_(most_triangles) {}

  TriangleMesh read() {
    while (!words_.atEnd()) {
      const std::string_view keyword = *words_.next();
      if (keyword == "v") {
        vertex();
      } else if (keyword == "f" || keyword == "fo") {
        face();
      }
      while (word()) {
      }
    }
    return builder_.take();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("line " + std::to_string(words_.line()) + ": " + what);
  }

  // In this line, or in the next one after a backslash.
  std::optional<std::string_view> word() {
    const auto found = words_.nextInLine();
    return found && *found == "\\" ? words_.next() : found;
  }

  void vertex() {
    Eigen::Vector3d at;
    for (int k = 0; k < 3; ++k) {
      const auto found = word();
      const auto number = found ? numberIn(*found) : std::nullopt;
      if (!number) {
        fail((found ? "found " + quoted(*found) : "the line ends") +
             "; expected a coordinate, a finite number");
      }
      at[k] = *number;
    }
    numbers_.push_back(builder_.vertex(at));
  }

  void face() {
    std::vector<std::uint32_t> corners;
    while (const auto found = word()) corners.push_back(corner(*found));
    if (corners.size() < 3) {
      fail("a face of " + std::to_string(corners.size()) + " corners; expected three or more");
    }
    builder_.polygon(corners);
  }

  std::uint32_t corner(std::string_view text) const {
    const std::string_view first = text.substr(0, text.find('/'));
    long long index = 0;
    const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), index);
    const auto count = static_cast<long long>(numbers_.size());
    const long long place = index < 0 ? count + index : index - 1;
    if (error != std::errc() || end != first.data() + first.size() || index == 0 || place < 0 ||
        place >= count) {
      fail("found the corner " + quoted(text) + "; expected one of the " + std::to_string(count) +
           " vertices so far");
    }
    return numbers_[static_cast<std::size_t>(place)];
  }

  TextTokens words_;
  SoupBuilder builder_;
  std::vector<std::uint32_t> numbers_;  // of the file's vertices
};

}  // namespace

TriangleMesh readObj(std::string_view file, std::size_t most_triangles) {
  if (file.find('\0') != std::string_view::npos) {
    throw std::invalid_argument("not readable as obj: it holds a byte 0; expected a text");
  }
  return ObjReader(file, most_triangles).read();
}

}  // namespace cable_variation
