#include <cable_variation/geometry/mesh/collada_check.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include <tinyxml2.h>

#include <cable_variation/util/text_tokens.h>
#include <cable_variation/util/xml_size.h>

namespace cable_variation {
namespace {

using tinyxml2::XMLElement;

constexpr std::uint64_t kMostNodes = 100000;  // with every instance of each
constexpr std::uint64_t kMostInputs = 64;
constexpr std::uint64_t kMostCorners = 10000;  // of a polygon: the time to divide it grows with the square

[[noreturn]] void fail(const XMLElement& at, const std::string& what) {
  throw std::invalid_argument("not readable as dae: line " + std::to_string(at.GetLineNum()) + ": " +
                              at.Name() + ": " + what);
}

std::string attribute(const XMLElement& of, const char* name) {
  const char* value = of.Attribute(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::optional<std::uint64_t> wholeNumber(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::uint64_t count(const XMLElement& of, const char* name, std::uint64_t otherwise) {
  const std::string text = attribute(of, name);
  if (text.empty()) return otherwise;
  const auto value = wholeNumber(text);
  if (!value) fail(of, std::string("found ") + name + " " + quoted(text) + "; expected a whole number");
  return *value;
}

// Calls visit for every element below, and itself.
template <typename Visit>
void visitAll(const XMLElement& element, const Visit& visit) {
  visit(element);
  for (const XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    visitAll(*child, visit);
  }
}

bool isNamed(const XMLElement& element, const char* name) { return std::strcmp(element.Name(), name) == 0; }

std::string allText(const XMLElement& element) {
  std::string text;
  for (const tinyxml2::XMLNode* node = element.FirstChild(); node; node = node->NextSibling()) {
    if (const auto* part = node->ToText()) text += part->Value();
  }
  return text;
}

std::vector<std::uint64_t> indices(const XMLElement& element) {
  const std::string text = allText(element);
  TextTokens words(text);
  std::vector<std::uint64_t> found;
  while (const auto word = words.next()) {
    const auto value = wholeNumber(*word);
    if (!value) fail(element, "found " + quoted(*word) + "; expected a whole number of at least 0");
    found.push_back(*value);
  }
  return found;
}

class ColladaCheck {
 public:
  explicit ColladaCheck(const XMLElement& root) : root_(root) {}

  void run() {
    visitAll(root_, [&](const XMLElement& element) {
      const std::string id = attribute(element, "id");
      if (id.empty()) return;
      const auto [known, is_new] = by_id_.emplace(id, &element);
      if (!is_new) known->second = nullptr;
    });
    visitAll(root_, [&](const XMLElement& element) {
      if (isNamed(element, "float_array")) checkArray(element);
      if (isNamed(element, "accessor")) checkAccessor(element);
      for (const char* shape :
           {"triangles", "polylist", "polygons", "tristrips", "trifans", "lines", "linestrips"}) {
        if (isNamed(element, shape)) checkShape(element);
      }
      for (const char* instance : {"instance_node", "instance_geometry", "instance_visual_scene"}) {
        if (isNamed(element, instance)) target(element, "url");
      }
    });
    std::uint64_t nodes = 0;
    visitAll(root_, [&](const XMLElement& element) {
      if (isNamed(element, "visual_scene")) nodes += nodesBelow(element, 0);
    });
    // also what no scene shows must not run in a circle
    visitAll(root_, [&](const XMLElement& element) {
      if (isNamed(element, "node")) nodesBelow(element, 0);
    });
    if (nodes > kMostNodes) {
      fail(root_, "its nodes, each counted as often as it is instanced, are more than " +
                      std::to_string(kMostNodes));
    }
  }

 private:
  // What `#id` names.
  const XMLElement& target(const XMLElement& of, const char* name) const {
    const std::string address = attribute(of, name);
    const auto found = address.empty() || address[0] != '#' ? by_id_.end() : by_id_.find(address.substr(1));
    if (found == by_id_.end()) {
      fail(of,
           std::string("found ") + name + " " + quoted(address) + "; expected # and the id of an element");
    }
    if (found->second == nullptr) fail(of, "found " + quoted(address) + ", an id that is there twice");
    return *found->second;
  }

  static void checkArray(const XMLElement& array) {
    const std::string text = allText(array);
    TextTokens words(text);
    std::uint64_t found = 0;
    while (const auto word = words.next()) {
      if (!numberIn(*word)) fail(array, "found " + quoted(*word) + "; expected a finite number");
      ++found;
    }
    const std::uint64_t announced = count(array, "count", 0);
    if (found != announced) {
      fail(array,
           "it announces " + std::to_string(announced) + " numbers and holds " + std::to_string(found));
    }
  }

  void checkAccessor(const XMLElement& accessor) const {
    const XMLElement& array = target(accessor, "source");
    const std::uint64_t held = count(array, "count", 0), entries = count(accessor, "count", 0),
                        stride = count(accessor, "stride", 1), offset = count(accessor, "offset", 0);
    if (stride == 0 || offset > held || entries > (held - offset) / stride) {
      fail(accessor, std::to_string(entries) + " entries of " + std::to_string(stride) + " from " +
                         std::to_string(offset) + "; expected no more than the " + std::to_string(held) +
                         " numbers of its array");
    }
  }

  // Entries of what an input of a primitive takes.
  std::uint64_t entriesOf(const XMLElement& input) const {
    const XMLElement* source = &target(input, "source");
    if (isNamed(*source, "vertices")) {
      const XMLElement* position = source->FirstChildElement("input");
      while (position && attribute(*position, "semantic") != "POSITION") {
        position = position->NextSiblingElement("input");
      }
      if (!position) fail(*source, "expected an input POSITION");
      source = &target(*position, "source");
      for (const XMLElement* other = target(input, "source").FirstChildElement("input"); other;
           other = other->NextSiblingElement("input")) {
        if (entriesOfSource(target(*other, "source")) < entriesOfSource(*source)) {
          fail(*other, "expected as many entries as there are positions");
        }
      }
    }
    return entriesOfSource(*source);
  }
  static std::uint64_t entriesOfSource(const XMLElement& source) {
    const XMLElement* common = source.FirstChildElement("technique_common");
    const XMLElement* accessor = common ? common->FirstChildElement("accessor") : nullptr;
    if (!isNamed(source, "source") || !accessor) fail(source, "expected a source with an accessor");
    return count(*accessor, "count", 0);
  }

  static void requireFewCorners(const XMLElement& at, std::uint64_t corners) {
    if (corners <= kMostCorners) return;
    fail(at, "a polygon of " + std::to_string(corners) + " corners; expected at most " +
                 std::to_string(kMostCorners));
  }

  void checkShape(const XMLElement& shape) const {
    std::uint64_t stride = 1;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> inputs;  // offset, entries
    for (const XMLElement* input = shape.FirstChildElement("input"); input;
         input = input->NextSiblingElement("input")) {
      const std::uint64_t offset = count(*input, "offset", 0);
      if (offset >= kMostInputs)
        fail(*input, "found offset " + std::to_string(offset) + "; expected less than 64");
      stride = std::max(stride, offset + 1);
      inputs.emplace_back(offset, entriesOf(*input));
    }
    std::uint64_t total = 0, lists = 0;
    for (const XMLElement* list = shape.FirstChildElement("p"); list; list = list->NextSiblingElement("p")) {
      const std::vector<std::uint64_t> found = indices(*list);
      if (inputs.empty() && !found.empty()) fail(shape, "expected inputs that its indices are of");
      if (found.size() % stride != 0) {
        fail(*list,
             std::to_string(found.size()) + " indices; expected a multiple of " + std::to_string(stride));
      }
      for (const auto& [offset, entries] : inputs) {
        for (std::uint64_t i = offset; i < found.size(); i += stride) {
          if (found[i] >= entries) {
            fail(*list, "found the index " + std::to_string(found[i]) + "; expected less than " +
                            std::to_string(entries));
          }
        }
      }
      total += found.size() / stride;
      ++lists;
      if (isNamed(shape, "polygons")) requireFewCorners(*list, found.size() / stride);
    }
    const std::uint64_t announced = count(shape, "count", 0);
    if (isNamed(shape, "triangles") || isNamed(shape, "lines")) {
      const std::uint64_t corners = isNamed(shape, "lines") ? 2 : 3;
      if (total % corners != 0 || total / corners != announced) {
        fail(shape, "it announces " + std::to_string(announced) + " and holds " + std::to_string(total) +
                        " corners; expected " + std::to_string(corners) + " each");
      }
    } else if (isNamed(shape, "polylist")) {
      const XMLElement* sizes = shape.FirstChildElement("vcount");
      std::uint64_t corners = 0, polygons = 0;
      if (sizes) {
        for (const std::uint64_t size : indices(*sizes)) {
          if (size > total)
            fail(*sizes, "a polygon of " + std::to_string(size) + " corners; there are not as many");
          requireFewCorners(*sizes, size);
          corners += size;
          ++polygons;
        }
      }
      if (polygons != announced || corners != total) {
        fail(shape, "it announces " + std::to_string(announced) + " polygons, of which vcount has " +
                        std::to_string(polygons) + " with " + std::to_string(corners) +
                        " corners; it holds " + std::to_string(total));
      }
    } else if (lists != announced) {
      fail(shape, "it announces " + std::to_string(announced) + " lists of indices and holds " +
                      std::to_string(lists));
    }
  }

  // Nodes below an element, each as often as it is instanced; no more than kMostNodes + 1 are counted.
  std::uint64_t nodesBelow(const XMLElement& element, int depth) {
    constexpr int kDeepest = 1000;
    const auto known = nodes_.find(&element);
    if (known != nodes_.end()) {
      if (known->second == kOpen) fail(element, "it instances itself, perhaps by way of others");
      return known->second;
    }
    if (depth > kDeepest) fail(element, "its nodes instance each other more than 1000 deep");
    nodes_[&element] = kOpen;
    std::uint64_t sum = isNamed(element, "node") ? 1 : 0;
    for (const XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
      if (isNamed(*child, "node")) sum += nodesBelow(*child, depth + 1);
      if (isNamed(*child, "instance_node")) sum += nodesBelow(target(*child, "url"), depth + 1);
      sum = std::min(sum, kMostNodes + 1);
    }
    nodes_[&element] = sum;
    return sum;
  }

  static constexpr std::uint64_t kOpen = static_cast<std::uint64_t>(-1);
  const XMLElement& root_;
  std::map<std::string, const XMLElement*> by_id_;  // null: there are several
  std::map<const XMLElement*, std::uint64_t> nodes_;
};

}  // namespace

void checkCollada(const std::string& text, std::size_t most_parts) {
  requireXmlSize(text, most_parts);
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw std::invalid_argument("not readable as dae: line " + std::to_string(document.ErrorLineNum()) +
                                ": no well-formed XML");
  }
  const XMLElement* root = document.RootElement();
  if (root == nullptr || !isNamed(*root, "COLLADA")) {
    throw std::invalid_argument("not readable as dae: expected the element COLLADA");
  }
  ColladaCheck(*root).run();
}

}  // namespace cable_variation
