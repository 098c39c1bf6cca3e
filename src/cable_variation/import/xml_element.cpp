#include <cable_variation/import/xml_element.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <cable_variation/util/input_limits.h>
#include <cable_variation/util/name_list.h>
#include <cable_variation/util/text_tokens.h>
#include <cable_variation/util/xml_size.h>

namespace cable_variation {
namespace {

// The element that follows in the order of the text, below `root`; an empty node after the last.
pugi::xml_node nextElement(pugi::xml_node node, const pugi::xml_node& root) {
  const auto elementFrom = [](pugi::xml_node candidate) {
    while (candidate && candidate.type() != pugi::node_element) candidate = candidate.next_sibling();
    return candidate;
  };
  if (const pugi::xml_node child = elementFrom(node.first_child())) return child;
  while (node != root) {
    if (const pugi::xml_node sibling = elementFrom(node.next_sibling())) return sibling;
    node = node.parent();
  }
  return {};
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words;
  TextTokens tokens(text);
  while (const auto word = tokens.next()) words.emplace_back(*word);
  return words;
}

}  // namespace

std::string localName(const pugi::xml_node& node) {
  const std::string name = node.name();
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

XmlIds::XmlIds(const std::string& text, FaultList& faults) : faults_(&faults) {
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
  try {
    requireXmlSize(text, InputLimits().xml_parts);
  } catch (const std::invalid_argument& error) {
    faults.add(0, error.what());
    return;
  }
  const pugi::xml_parse_result result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_auto);
  if (!result) {
    const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(),
                                       static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)));
    faults.add(static_cast<int>(line - line_starts_.begin()),
               std::string("the file is no XML: ") + result.description());
    document_.reset();
    return;
  }
  for (pugi::xml_node node = root(); node; node = nextElement(node, root())) {
    const pugi::xml_attribute id = node.attribute("id");
    if (!id) continue;
    const auto [place, is_new] = elements_.emplace(id.value(), node);
    if (is_new) continue;
    faults.add(lineOf(node), "the id '" + std::string(id.value()) + "' of a " + localName(node) +
                                 " is that of a " + localName(place->second) + " in line " +
                                 std::to_string(lineOf(place->second)) + " too; expected another one");
  }
}

pugi::xml_node XmlIds::find(const std::string& id) const {
  const auto place = elements_.find(id);
  return place == elements_.end() ? pugi::xml_node() : place->second;
}

int XmlIds::lineOf(const pugi::xml_node& node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset < 0) return 0;
  const auto line =
      std::upper_bound(line_starts_.begin(), line_starts_.end(), static_cast<std::size_t>(offset));
  return static_cast<int>(line - line_starts_.begin());
}

std::string XmlElement::label() const {
  std::string path;
  for (pugi::xml_node node = node_; node; node = node.parent()) {
    const std::string id = node.attribute("id").value();
    const bool outermost = !node.parent().parent().parent() || localName(node.parent()) == "Harness";
    if (outermost && (!id.empty() || !node.parent().parent()))
      return localName(node) + (id.empty() ? "" : " '" + id + "'") + (path.empty() ? "" : ", " + path);
    path = localName(node) + (path.empty() ? "" : "/" + path);
  }
  return path;
}

void XmlElement::fail(const std::string& message) const {
  ids_->faults().add(line(), label() + ": " + message);
}

std::vector<XmlElement> XmlElement::children(const std::string& name) const {
  std::vector<XmlElement> found;
  for (const pugi::xml_node& child : node_.children()) {
    if (child.type() == pugi::node_element && localName(child) == name) found.emplace_back(child, *ids_);
  }
  return found;
}

std::optional<XmlElement> XmlElement::find(const std::string& name) const {
  for (const pugi::xml_node& child : node_.children()) {
    if (child.type() == pugi::node_element && localName(child) == name) return XmlElement(child, *ids_);
  }
  return {};
}

std::optional<XmlElement> XmlElement::require(const std::string& name) const {
  const auto found = find(name);
  if (!found) fail("'" + name + "' is missing");
  return found;
}

std::vector<XmlElement> XmlElement::below(const std::vector<std::string>& kinds) const {
  std::vector<XmlElement> found;
  for (pugi::xml_node node = nextElement(node_, node_); node; node = nextElement(node, node_)) {
    if (std::find(kinds.begin(), kinds.end(), localName(node)) != kinds.end())
      found.emplace_back(node, *ids_);
  }
  return found;
}

std::string XmlElement::text() const {
  const std::string text = node_.text().get();
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return {};
  const std::string trimmed = text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
  return trimmed == "/NULL" ? std::string() : trimmed;
}

std::string XmlElement::textOf(const std::string& name) const {
  const auto child = find(name);
  return child ? child->text() : std::string();
}

double XmlElement::number() const {
  const std::string word = text();
  if (const auto value = numberIn(word)) return *value;
  fail("found " + quoted(word) + "; expected a number");
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> XmlElement::numbers(const std::string& name, std::size_t count) const {
  const std::vector<XmlElement> found = children(name);
  if (found.size() != count) {
    fail("'" + name + "' is there " + std::to_string(found.size()) + " times; expected " +
         std::to_string(count) + " numbers");
    return {};
  }
  std::vector<double> values;
  values.reserve(count);
  for (const XmlElement& value : found) values.push_back(value.number());
  return values;
}

std::optional<XmlElement> XmlElement::elementOf(const std::string& id,
                                                const std::vector<std::string>& kinds) const {
  const pugi::xml_node found = ids_->find(id);
  if (!found) {
    fail("there is nothing of the id " + quoted(id) + "; expected that of a " + joined(kinds));
    return {};
  }
  const std::string kind = localName(found);
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    fail(quoted(id) + " is the id of a " + kind + "; expected that of a " + joined(kinds));
    return {};
  }
  return XmlElement(found, *ids_);
}

std::optional<XmlElement> XmlElement::target(const std::vector<std::string>& kinds) const {
  return elementOf(text(), kinds);
}

std::vector<XmlElement> XmlElement::targets(const std::vector<std::string>& kinds) const {
  std::vector<XmlElement> found;
  for (const std::string& id : wordsOf(text())) {
    if (const auto element = elementOf(id, kinds)) found.push_back(*element);
  }
  return found;
}

}  // namespace cable_variation
