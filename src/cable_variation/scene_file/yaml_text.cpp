#include <cable_variation/scene_file/yaml_text.h>

#include <algorithm>

namespace cable_variation {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool startsComment(const std::string& text, std::size_t at) {
  return text[at] == '#' && (at == 0 || isBlank(text[at - 1]));
}

std::size_t lineEnd(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

std::size_t skipBlanks(const std::string& text, std::size_t at) {
  while (at < text.size() && (isBlank(text[at]) || startsComment(text, at))) {
    at = text[at] == '#' ? lineEnd(text, at) : at + 1;
  }
  return at;
}

// Behind the closing quote.
std::size_t quoteEnd(const std::string& text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '"' || at + 1 >= text.size() || text[at + 1] != quote) return at + 1;
      ++at;  // '' within '...'
    }
  }
  return text.size();
}

// Behind the bracket that closes the one at `at`.
std::size_t bracketEnd(const std::string& text, std::size_t at) {
  std::size_t depth = 0;
  bool token_starts = true;
  while (at < text.size()) {
    const char c = text[at];
    if (startsComment(text, at)) {
      at = lineEnd(text, at);
    } else if (token_starts && (c == '"' || c == '\'')) {
      at = quoteEnd(text, at);
      token_starts = false;
    } else {
      if (c == '{' || c == '[') ++depth;
      if ((c == '}' || c == ']') && --depth == 0) return at + 1;
      if (!isBlank(c)) token_starts = c == '{' || c == '[' || c == ',' || c == ':';
      ++at;
    }
  }
  return at;
}

std::size_t plainEnd(const std::string& text, std::size_t at, bool in_flow) {
  const std::size_t begin = at;
  while (at < text.size() && text[at] != '\n' && !startsComment(text, at)) {
    const char c = text[at];
    if (in_flow && (c == ',' || c == '}' || c == ']' || c == '{' || c == '[')) break;
    ++at;
  }
  while (at > begin && isBlank(text[at - 1])) --at;
  return at;
}

// Behind the colon of a key.
std::size_t colonEnd(const std::string& text, std::size_t at) {
  if (text[at] == '"' || text[at] == '\'') at = quoteEnd(text, at);
  return std::min(text.find(':', at), text.size() - 1) + 1;
}

// Behind anchor and tag.
std::size_t skipProperties(const std::string& text, std::size_t at) {
  while (at < text.size() && (text[at] == '&' || text[at] == '!')) {
    while (at < text.size() && !isBlank(text[at])) ++at;
    at = skipBlanks(text, at);
  }
  return at;
}

std::size_t placeOf(const YAML::Node& node) { return static_cast<std::size_t>(node.Mark().pos); }

bool isFlow(const std::string& text, const YAML::Node& collection) {
  const std::size_t at = placeOf(collection);
  return at < text.size() && (text[at] == '{' || text[at] == '[');
}

}  // namespace

std::optional<YamlText::Range> YamlText::valueOf(const YAML::Node& map, const std::string& key) const {
  if (!map.IsMap()) return {};
  for (const auto& entry : map) {
    if (!entry.first.IsScalar() || entry.first.Scalar() != key) continue;
    const std::size_t begin = skipProperties(text_, skipBlanks(text_, colonEnd(text_, placeOf(entry.first))));
    return Range{begin, endOf(entry.second, begin, isFlow(text_, map))};
  }
  return {};
}

std::optional<YamlText::Range> YamlText::entryOf(const YAML::Node& map, const std::string& key) const {
  auto range = valueOf(map, key);
  for (const auto& entry : map) {
    if (range && entry.first.IsScalar() && entry.first.Scalar() == key) range->begin = placeOf(entry.first);
  }
  return range;
}

std::size_t YamlText::endOf(const YAML::Node& node, std::size_t begin, bool in_flow) const {
  if (begin >= text_.size()) return text_.size();
  const char first = text_[begin];
  if (first == '"' || first == '\'') return quoteEnd(text_, begin);
  if (first == '{' || first == '[') return bracketEnd(text_, begin);
  if (first == '*' || !(node.IsMap() || node.IsSequence())) return plainEnd(text_, begin, in_flow);
  std::size_t end = begin;
  if (node.IsMap()) {
    for (const auto& entry : node) {
      if (const auto value = valueOf(node, entry.first.Scalar())) end = std::max(end, value->end);
    }
  } else {
    for (const YAML::Node& item : node) end = std::max(end, endOfItem(item));
  }
  return end;
}

std::size_t YamlText::endOfItem(const YAML::Node& item) const { return endOf(item, placeOf(item), false); }

std::size_t YamlText::endOfLine(std::size_t at) const { return lineEnd(text_, at); }

std::string YamlText::indentAt(std::size_t at) const {
  const std::size_t begin = at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
  return std::string(at - begin, ' ');
}

void YamlText::addEntry(const YAML::Node& map, const std::string& behind, const std::string& key,
                        const std::string& value) {
  const auto entry = entryOf(map, behind);
  if (!entry) return;
  if (isFlow(text_, map)) {
    replace({entry->end, entry->end}, ", " + key + ": " + value);
  } else {
    const std::size_t end = endOfLine(entry->end);
    replace({end, end}, "\n" + indentAt(entry->begin) + key + ": " + value);
  }
}

void YamlText::addItems(const YAML::Node& map, const std::string& list,
                        const std::vector<std::string>& items) {
  if (items.empty()) return;
  const YAML::Node there = map[list];
  if (!there || there.size() == 0) {
    addList(map, list, items);
    return;
  }
  for (const std::string& item : items) addItem(there, item);
}

void YamlText::addList(const YAML::Node& map, const std::string& list,
                       const std::vector<std::string>& items) {
  std::string flow, block;
  for (const std::string& item : items) {
    flow += (flow.empty() ? "" : ", ") + item;
    block += "\n  - " + item;
  }
  if (const auto empty = valueOf(map, list)) {  // the key with [] behind it
    replace(*empty, "[" + flow + "]");
  } else if (isFlow(text_, map)) {
    const std::size_t end = text_.rfind('}');
    replace({end, end}, ", " + list + ": [" + flow + "]");
  } else {
    const bool own_line = !text_.empty() && text_.back() == '\n';
    replace({text_.size(), text_.size()}, (own_line ? "" : "\n") + list + ":" + block + "\n");
  }
}

void YamlText::addItem(const YAML::Node& items, const std::string& item) {
  const YAML::Node last = items[items.size() - 1];
  const std::size_t end = endOfItem(last);
  if (isFlow(text_, items)) {
    replace({end, end}, ", " + item);
    return;
  }
  const std::size_t dash = text_.rfind('-', placeOf(last));
  const std::size_t line_end = endOfLine(end);
  replace({line_end, line_end}, "\n" + indentAt(dash) + "- " + item);
}

std::string YamlText::edited() const {
  std::vector<Edit> edits = edits_;
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.range.begin < b.range.begin; });
  std::string text;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    text.append(text_, at, edit.range.begin - at);
    text += edit.by;
    at = edit.range.end;
  }
  return text.append(text_, at, std::string::npos);
}

}  // namespace cable_variation
