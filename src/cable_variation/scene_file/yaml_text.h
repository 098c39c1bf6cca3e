#pragma once  // internal to scene_file/

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace cable_variation {

/// A YAML text that is edited where its values stand; all else, comments and order too, stays as it is. Nodes
/// are those of the document that was read from this text, places are looked up in what the text was at
/// first, and no two edits may overlap.
class YamlText {
 public:
  explicit YamlText(std::string text) : text_(std::move(text)) {}

  struct Range {
    std::size_t begin, end;
  };

  /// Where the value of a map's key stands, without its anchor and tag; an alias is its own text. Nothing if
  /// the map does not have the key itself.
  std::optional<Range> valueOf(const YAML::Node& map, const std::string& key) const;
  /// Likewise the key with its value.
  std::optional<Range> entryOf(const YAML::Node& map, const std::string& key) const;
  std::string at(const Range& range) const { return text_.substr(range.begin, range.end - range.begin); }

  void replace(const Range& range, std::string by) { edits_.push_back({range, std::move(by)}); }
  /// Adds a key with its value behind the entry of another one, which must be there.
  void addEntry(const YAML::Node& map, const std::string& behind, const std::string& key,
                const std::string& value);
  /// Adds items, a text on one line each, behind the last one of the list that a map has. If it has none,
  /// one is written behind all else, the map being the document's.
  void addItems(const YAML::Node& map, const std::string& list, const std::vector<std::string>& items);

  /// The text with all edits.
  std::string edited() const;

 private:
  struct Edit {
    Range range;
    std::string by;
  };
  void addItem(const YAML::Node& items, const std::string& item);
  void addList(const YAML::Node& map, const std::string& list, const std::vector<std::string>& items);
  std::size_t endOf(const YAML::Node& node, std::size_t begin, bool in_flow) const;
  std::size_t endOfItem(const YAML::Node& item) const;
  std::size_t endOfLine(std::size_t at) const;
  std::string indentAt(std::size_t at) const;

  std::string text_;
  std::vector<Edit> edits_;
};

}  // namespace cable_variation
