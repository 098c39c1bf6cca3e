#include <cable_variation/scene_file/yaml_cursor.h>
#include <cable_variation/util/name_list.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace cable_variation {
namespace {

const std::string kMergeKey = "<<";
constexpr double kTurn = 2.0 * M_PI;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

int lineOf(const YAML::Node& node) { return node.Mark().line + 1; }

constexpr Dimension kFitsNoUnit{0, 0, 0, -99};

// More than a turn, and not so many half turns that somebody has counted them.
bool isLikelyInDegrees(double angle) {
  constexpr double kRounding = 0.01;
  const double half_turns = std::round(2.0 * angle / kTurn);
  return std::abs(angle) > kTurn + kRounding && std::abs(angle - half_turns * kTurn / 2.0) > kRounding;
}

std::string keyText(const YAML::Node& key) { return key.IsScalar() ? key.Scalar() : "(no plain key)"; }

}  // namespace

void YamlCursor::fail(const std::string& message) const {
  faults_->add(line_, label_.empty() ? message : label_ + ": " + message);
}

void YamlCursor::warn(const std::string& message) const {
  faults_->warn(line_, label_.empty() ? message : label_ + ": " + message);
}

std::string YamlCursor::found() const {
  if (node_.IsMap()) return "found a map";
  if (node_.IsSequence()) return "found a list";
  if (node_.IsScalar()) return "found '" + node_.Scalar() + "'";
  return "found nothing";
}

std::string YamlCursor::foundAs(double value, const std::string& unit) const {
  const std::string is = shortNumber(value) + (unit == "1" ? "" : " " + unit);
  return node_.IsScalar() && node_.Scalar() == is ? found() : found() + ", which is " + is;
}

bool YamlCursor::checkKeys(const std::vector<std::string>& allowed) const {
  if (!node_.IsMap()) {
    fail(found() + "; expected a map with keys " + joined(allowed));
    return false;
  }
  std::set<std::string> seen;
  for (const auto& [key, value] : entries()) {
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) {
      labelled(label_).faults_->add(value.line(), (label_.empty() ? "" : label_ + ": ") + "unknown key '" +
                                                      key + "'" + didYouMean(key, allowed));
    } else if (!seen.insert(key).second) {
      faults_->add(value.line(), (label_.empty() ? "" : label_ + ": ") + "key '" + key + "' is there twice");
    }
  }
  return true;
}

std::vector<std::pair<std::string, YamlCursor>> YamlCursor::entries() const {
  std::vector<std::pair<std::string, YamlCursor>> result;
  std::vector<YamlCursor> merged;
  if (!node_.IsMap()) return result;
  for (const auto& entry : node_) {
    const std::string key = keyText(entry.first);
    const YamlCursor value(entry.second, lineOf(entry.first), label_.empty() ? key : label_ + ", " + key,
                           *faults_);
    const bool merges = key == kMergeKey && (value.isMap() || value.isList());
    if (merges) {
      merged.push_back(value);
    } else {
      result.emplace_back(key, value);
    }
  }
  for (const YamlCursor& value : merged) value.labelled(label_).mergeInto(result);
  return result;
}

// Own keys go first, then those of the first map of a list.
void YamlCursor::mergeInto(std::vector<std::pair<std::string, YamlCursor>>& entries) const {
  if (isList()) {
    for (const YAML::Node& item : node_) YamlCursor(item, lineOf(item), label_, *faults_).mergeInto(entries);
    return;
  }
  const std::size_t own = entries.size();
  for (auto& entry : this->entries()) {
    const auto same = [&](const auto& other) { return other.first == entry.first; };
    if (std::none_of(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(own), same)) {
      entries.push_back(std::move(entry));
    }
  }
}

std::optional<YamlCursor> YamlCursor::find(const std::string& key) const {
  for (auto& [name, value] : entries()) {
    if (name == key) return value;
  }
  return {};
}

std::optional<YamlCursor> YamlCursor::require(const std::string& key) const {
  std::optional<YamlCursor> value = find(key);
  if (!value) fail("'" + key + "' is missing");
  return value;
}

bool YamlCursor::isAtMost(std::size_t most, const char* limit) const {
  const std::size_t size = node_.IsSequence() || node_.IsMap() ? node_.size() : 0;
  if (size > most) fail("found " + std::to_string(size) + " entries; " + atMost(most, limit));
  return size <= most;
}

std::vector<YamlCursor> YamlCursor::items(std::optional<std::size_t> count) const {
  std::vector<YamlCursor> result;
  if (!node_.IsSequence()) {
    fail(found() + "; expected a list" + (count ? " of " + std::to_string(*count) : ""));
    return result;
  }
  for (const YAML::Node& item : node_) {
    const std::string index = "[" + std::to_string(result.size()) + "]";
    result.emplace_back(item, item.IsNull() ? line_ : lineOf(item), label_ + index, *faults_);
  }
  if (count && result.size() != *count) {
    fail("found a list of " + std::to_string(result.size()) + "; expected " + std::to_string(*count));
    result.clear();
  }
  return result;
}

std::string YamlCursor::text() const {
  if (!node_.IsScalar() || node_.Scalar().empty()) {
    fail((node_.IsScalar() ? "found an empty text" : found()) + "; expected a text");
    return {};
  }
  return node_.Scalar();
}

bool YamlCursor::isBareNumber() const {
  try {
    return isScalar() && !readQuantity(node_.Scalar(), Quantity{"a number", "", "1", kFitsNoUnit}).has_unit;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

bool YamlCursor::flag() const {
  bool value = false;
  if (!node_.IsScalar() || !YAML::convert<bool>::decode(node_, value))
    fail(found() + "; expected true or false");
  return value;
}

double YamlCursor::number(const Quantity& quantity, const Range& range) const {
  if (!node_.IsScalar()) {
    fail(found() + "; expected " + quantity.name + ", e.g. '" + quantity.example + "'");
    return kNone;
  }
  try {
    const QuantityText number = readQuantity(node_.Scalar(), quantity);
    if (!range.holds(number.value)) {
      fail(found() + "; expected " + range.text(quantity.unit));
      return kNone;
    }
    if (&quantity == &quantity::angle && !number.has_unit && isLikelyInDegrees(number.value)) {
      warn(found() + " without a unit, which is " + shortNumber(number.value) + " rad; in deg?");
    }
    return number.value;
  } catch (const std::invalid_argument& error) {
    fail(error.what());
  }
  return kNone;
}

Eigen::Vector3d YamlCursor::vector(const Quantity& quantity) const {
  Eigen::Vector3d value = Eigen::Vector3d::Constant(kNone);
  const std::vector<YamlCursor> numbers = items(3);
  for (std::size_t i = 0; i < numbers.size(); ++i) value[static_cast<int>(i)] = numbers[i].number(quantity);
  return value;
}

std::size_t YamlCursor::choice(const std::vector<std::string>& allowed) const {
  if (node_.IsScalar()) {
    const auto it = std::find(allowed.begin(), allowed.end(), node_.Scalar());
    if (it != allowed.end()) return static_cast<std::size_t>(it - allowed.begin());
  }
  fail(found() + "; expected one of " + joined(allowed));
  return 0;
}

std::string YamlCursor::text(const std::string& key) const {
  const auto value = require(key);
  return value ? value->text() : std::string();
}

double YamlCursor::number(const std::string& key, const Quantity& quantity, const Range& range) const {
  const auto value = require(key);
  return value ? value->number(quantity, range) : kNone;
}

Eigen::Vector3d YamlCursor::vector(const std::string& key, const Quantity& quantity) const {
  const auto value = require(key);
  return value ? value->vector(quantity) : Eigen::Vector3d::Constant(kNone).eval();
}

std::size_t YamlCursor::choice(const std::string& key, const std::vector<std::string>& allowed) const {
  const auto value = require(key);
  return value ? value->choice(allowed) : 0;
}

double YamlCursor::number(const std::string& key, const Quantity& quantity, const Range& range,
                          double fallback) const {
  const auto value = find(key);
  return value ? value->number(quantity, range) : fallback;
}

Eigen::Vector3d YamlCursor::vector(const std::string& key, const Quantity& quantity,
                                   const Eigen::Vector3d& fallback) const {
  const auto value = find(key);
  return value ? value->vector(quantity) : fallback;
}

bool YamlCursor::flag(const std::string& key, bool fallback) const {
  const auto value = find(key);
  return value ? value->flag() : fallback;
}

}  // namespace cable_variation
