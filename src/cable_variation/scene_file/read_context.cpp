#include <cable_variation/scene_file/read_context.h>
#include <cable_variation/util/name_list.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace cable_variation {
namespace {

// Letters, digits, _ - . and whatever is beyond ASCII; a letter, digit or _ first.
bool isName(const std::string& text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c >= 0x80; };
  return !text.empty() && plain(static_cast<unsigned char>(text.front())) &&
         std::all_of(text.begin(), text.end(),
                     [&](char c) { return plain(static_cast<unsigned char>(c)) || c == '-' || c == '.'; });
}

}  // namespace

YamlCursor NameTable::add(const YamlCursor& item) {
  const auto value = item.find("name");
  std::string name = value && value->isScalar() ? value->text() : std::string();
  if (!item.isMap()) {
    // the reader's checkKeys tells
  } else if (!value) {
    item.fail("'name' is missing");
  } else if (!isName(name)) {
    value->fail("found '" + name + "'; expected letters, digits, '_', '-' and '.'");
  } else if (name.size() > longest_) {
    value->fail("the name has " + std::to_string(name.size()) + " bytes; " + atMost(longest_, "name_bytes"));
    name.clear();
  } else if (const auto known = indices_.find(name); known != indices_.end()) {
    value->fail("there is a " + kind_ + " '" + name + "' already, in line " +
                std::to_string(lines_[known->second]));
  }
  append(name, item.line());
  return name.empty() ? item : item.labelled(kind_ + " '" + name + "'");
}

void NameTable::append(const std::string& name, int line) {
  indices_.emplace(name, names_.size());
  names_.push_back(name);
  lines_.push_back(line);
}

void NameTable::declare(const YamlCursor& item, const std::string& name) {
  const auto known = indices_.find(name);
  if (known != indices_.end()) {
    item.fail("there is a " + kind_ + " '" + name + "' already, in line " +
              std::to_string(lines_[known->second]));
  }
  append(name, item.line());
}

std::size_t NameTable::find(const YamlCursor& cursor) const {
  const std::string name = cursor.text();
  if (name.empty()) return npos;
  const auto known = indices_.find(name);
  if (known != indices_.end()) return known->second;
  cursor.fail("there is no " + kind_ + " '" + name + "'" + didYouMean(name, names_));
  return npos;
}

std::size_t NameTable::find(const YamlCursor& cursor, const std::string& key) const {
  const auto value = cursor.require(key);
  return value ? find(*value) : npos;
}

double ReadContext::cableLength(std::size_t cable) const {
  return cable == NameTable::npos ? std::numeric_limits<double>::quiet_NaN()
                                  : scene.harness.cables[cable].length;
}

double readArcLength(const YamlCursor& cursor, double cable_length) {
  if (cursor.isScalar()) {
    if (cursor.text() == "start") return 0.0;
    if (cursor.text() == "end") return cable_length;
  }
  static const Quantity arc_length{"start, end or a length", "m", "140 mm", {0, 1, 0, 0}};
  Range range = Range::notNegative();
  if (cable_length > 0.0) range.high = cable_length;
  return cursor.number(arc_length, range);
}

}  // namespace cable_variation
