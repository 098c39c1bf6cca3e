#pragma once

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <tinyxml2.h>

namespace cable_variation {

/// A table of a page as it is read there.
struct PageTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// Of the row that begins with `name`, below the heading `column`. Throws std::out_of_range.
  const std::string& cell(const std::string& name, const std::string& column) const {
    for (const auto& row : rows) {
      if (row.front() != name) continue;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i] == column) return row.at(i);
      }
    }
    throw std::out_of_range(name + ", " + column);
  }
};

inline void appendText(const tinyxml2::XMLNode& node, std::string& text) {
  for (const auto* child = node.FirstChild(); child != nullptr; child = child->NextSibling()) {
    if (child->ToText() != nullptr) text += child->Value();
    if (child->ToElement() != nullptr && std::string(child->Value()) == "br") text += ' ';
    appendText(*child, text);
  }
}

inline std::string textOf(const tinyxml2::XMLNode& node) {
  std::string text;
  appendText(node, text);
  return text;
}

inline void collect(const tinyxml2::XMLElement& element, const char* name,
                    std::vector<const tinyxml2::XMLElement*>& found) {
  if (std::string(element.Name()) == name) found.push_back(&element);
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    collect(*child, name, found);
  }
}

/// A page, read by a parser that refuses what is not well-formed.
class ReadPage {
 public:
  /// Throws std::invalid_argument that says what is wrong with it.
  explicit ReadPage(const std::string& page) {
    if (document_.Parse(page.data(), page.size()) != tinyxml2::XML_SUCCESS) {
      throw std::invalid_argument(document_.ErrorStr());
    }
  }

  std::vector<const tinyxml2::XMLElement*> all(const char* name) const {
    std::vector<const tinyxml2::XMLElement*> found;
    collect(*document_.RootElement(), name, found);
    return found;
  }

  std::vector<PageTable> tables() const {
    std::vector<PageTable> tables;
    for (const auto* element : all("table")) {
      PageTable table;
      std::vector<const tinyxml2::XMLElement*> rows;
      collect(*element, "tr", rows);
      for (const auto* row : rows) {
        std::vector<std::string> cells;
        for (const auto* cell = row->FirstChildElement(); cell != nullptr;
             cell = cell->NextSiblingElement()) {
          cells.push_back(textOf(*cell));
        }
        if (row == rows.front()) {
          table.columns = cells;
        } else {
          table.rows.push_back(cells);
        }
      }
      tables.push_back(table);
    }
    return tables;
  }

  /// The first whose headings are among others these. Throws std::out_of_range.
  PageTable table(const std::vector<std::string>& columns) const {
    for (const PageTable& each : tables()) {
      std::size_t found = 0;
      for (const std::string& column : columns) {
        for (const std::string& heading : each.columns) found += heading == column ? 1 : 0;
      }
      if (found == columns.size()) return each;
    }
    throw std::out_of_range("a table with a column " + columns.front());
  }

 private:
  tinyxml2::XMLDocument document_;
};

/// A figure as it is written, with its true minus sign.
inline double number(std::string text) {
  const std::string minus = "−";
  if (text.compare(0, minus.size(), minus) == 0) text.replace(0, minus.size(), "-");
  if (text == "∞") return HUGE_VAL;
  return std::strtod(text.c_str(), nullptr);
}

}  // namespace cable_variation
