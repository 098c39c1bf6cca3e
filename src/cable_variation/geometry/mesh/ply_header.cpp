#include <cable_variation/geometry/mesh/ply_header.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>

#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

constexpr std::size_t kMostElements = 100, kMostProperties = 1000;

[[noreturn]] void fail(std::size_t line, const std::string& what) {
  throw std::invalid_argument("line " + std::to_string(line) + " of the header: " + what);
}

PlyType typeNamed(const std::string& name, std::size_t line) {
  static const std::map<std::string, PlyType> types = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  const auto found = types.find(name);
  if (found == types.end()) {
    fail(line, "found the type " + quoted(name) +
                   "; expected char, uchar, short, ushort, int, uint, float, double or int8 to float64");
  }
  return found->second;
}

std::vector<std::string> wordsIn(std::string_view line) {
  std::vector<std::string> words;
  TextTokens tokens(line);
  while (const auto word = tokens.nextInLine()) words.emplace_back(*word);
  return words;
}

PlyProperty property(const std::vector<std::string>& words, std::size_t line) {
  PlyProperty result;
  const bool list = words.size() > 1 && words[1] == "list";
  if (words.size() != (list ? 5U : 3U)) {
    fail(line, "expected property TYPE NAME or property list TYPE TYPE NAME");
  }
  if (list) {
    result.count = typeNamed(words[2], line);
    if (*result.count == PlyType::float32 || *result.count == PlyType::float64) {
      fail(line, "found a list whose count is " + quoted(words[2]) + "; expected a whole number's type");
    }
  }
  result.type = typeNamed(words[words.size() - 2], line);
  result.name = words.back();
  return result;
}

PlyElement element(const std::vector<std::string>& words, std::size_t line) {
  PlyElement result;
  if (words.size() != 3) fail(line, "expected element NAME COUNT");
  result.name = words[1];
  const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), result.count);
  if (error != std::errc() || end != words[2].data() + words[2].size()) {
    fail(line, "found " + quoted(words[2]) + "; expected how many elements there are");
  }
  return result;
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::float64:
      return 8;
    default:
      return 4;
  }
}

std::optional<std::size_t> PlyElement::find(const std::vector<std::string>& names) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) return i;
  }
  return std::nullopt;
}

PlyHeader::PlyHeader(std::string_view file) {
  if (file.substr(0, 3) != "ply") throw std::invalid_argument("it does not begin with ply");
  // the first line tells how all end, so that data may begin with a byte that is a line's end elsewhere
  const std::size_t first = file.find_first_of("\r\n");
  if (first == std::string_view::npos) throw std::invalid_argument("it ends within its header");
  const std::string ending = file[first] == '\n' ? "\n" : file.substr(first, 2) == "\r\n" ? "\r\n" : "\r";
  bool has_format = false;
  for (std::size_t at = 0;;) {
    const std::size_t end = file.find(ending, at);
    if (end == std::string_view::npos) throw std::invalid_argument("it ends within its header");
    const std::vector<std::string> words = wordsIn(file.substr(at, end - at));
    at = end + ending.size();
    ++lines;
    if (lines == 1) {
      if (words != std::vector<std::string>{"ply"}) fail(lines, "expected ply alone");
      continue;
    }
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      size = at;
      break;
    }
    if (words[0] == "format") {
      static const std::map<std::string, Format> formats = {{"ascii", Format::text},
                                                            {"binary_little_endian", Format::little_endian},
                                                            {"binary_big_endian", Format::big_endian}};
      const auto found = words.size() == 3 && words[2] == "1.0" ? formats.find(words[1]) : formats.end();
      if (found == formats.end() || has_format) {
        fail(lines, "expected one format, ascii, binary_little_endian or binary_big_endian, of version 1.0");
      }
      format = found->second;
      has_format = true;
    } else if (words[0] == "element") {
      elements.push_back(element(words, lines));
      if (elements.size() > kMostElements) fail(lines, "more than 100 elements; expected vertex and face");
      for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
        if (elements[i].name == elements.back().name) {
          fail(lines, "found the element " + quoted(elements[i].name) + " twice");
        }
      }
    } else if (words[0] == "property" && !elements.empty()) {
      PlyProperty made = property(words, lines);
      if (elements.back().find({made.name}))
        fail(lines, "found the property " + quoted(made.name) + " twice");
      elements.back().properties.push_back(std::move(made));
      if (elements.back().properties.size() > kMostProperties) {
        fail(lines, "more than 1000 properties of an element; expected fewer");
      }
    } else {
      fail(lines,
           "found " + quoted(words[0]) +
               "; expected format, element, property (of an element), comment, obj_info or end_header");
    }
  }
  if (!has_format) throw std::invalid_argument("the header names no format");
}

}  // namespace cable_variation
