#include <cable_variation/identification/measured_points.h>

#include <array>
#include <limits>
#include <optional>
#include <stdexcept>

#include <cable_variation/util/data_lines.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/text_tokens.h>

namespace cable_variation {

namespace {

constexpr std::uintmax_t kMostBytes = 100'000'000;
constexpr std::size_t kMostPoints = 100'000;

std::string trimmed(const std::string& text) {
  constexpr const char* kAround = " \t\r\"";
  const std::size_t first = text.find_first_not_of(kAround);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kAround) - first + 1);
}

/// By commas or semicolons if there are any, else by blanks.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  if (line.find_first_of(",;") == std::string::npos) {
    TextTokens words(line);
    while (const auto word = words.next()) cells.emplace_back(*word);
    return cells;
  }
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find_first_of(",;", at), line.size());
    cells.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return cells;
}

/// A column of the table that is one of the three coordinates.
struct Column {
  std::size_t axis = 0;
  double unit = 1.0;  // [m]
};

std::optional<Column> columnOf(const std::string& title) {
  const std::string name = lowerCase(title);
  if (name.empty() || name[0] < 'x' || name[0] > 'z') return std::nullopt;
  Column column{static_cast<std::size_t>(name[0] - 'x'), 1.0};
  std::string unit = trimmed(title.substr(1));
  if (unit.empty()) return column;
  if (unit[0] != '[' && unit[0] != '(' && unit[0] != '_') return std::nullopt;
  unit = trimmed(unit.substr(1));
  if (!unit.empty() && (unit.back() == ']' || unit.back() == ')')) unit.pop_back();
  column.unit = parseQuantity("1 " + unit, quantity::length);
  return column;
}

class Table {
 public:
  void take(const std::string& line) {
    const std::vector<std::string> cells = cellsOf(line);
    if (columns_.empty()) {
      readTitles(cells);
    } else {
      readPoint(cells);
    }
  }

  std::vector<Eigen::Vector3d> points;

 private:
  void readTitles(const std::vector<std::string>& cells) {
    std::array<bool, 3> has{};
    for (const std::string& cell : cells) {
      columns_.push_back(columnOf(cell));
      if (!columns_.back()) continue;
      if (has[columns_.back()->axis])
        throw std::invalid_argument("column " + quoted(cell) + " is there twice");
      has[columns_.back()->axis] = true;
    }
    if (has[0] && has[1]) return;
    throw std::invalid_argument("no column '" + std::string(has[0] ? "y" : "x") +
                                "'; expected a line of titles such as 'x [m],y [m],z [m]'");
  }

  void readPoint(const std::vector<std::string>& cells) {
    if (cells.size() != columns_.size()) {
      throw std::invalid_argument(std::to_string(cells.size()) + " values; expected " +
                                  std::to_string(columns_.size()) + " as in the line of titles");
    }
    if (points.size() == kMostPoints)
      throw std::invalid_argument("more than " + std::to_string(kMostPoints) + " points");
    points.emplace_back(Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!columns_[i]) continue;
      const std::optional<double> value = numberIn(cells[i]);
      if (!value) throw std::invalid_argument(quoted(cells[i]) + " is no number");
      points.back()[static_cast<Eigen::Index>(columns_[i]->axis)] = columns_[i]->unit * *value;
    }
  }

  std::vector<std::optional<Column>> columns_;
};

}  // namespace

std::vector<Eigen::Vector3d> readMeasuredPoints(const std::string& path) {
  Table table;
  readDataLines(path, kMostBytes, [&](const std::string& line) { table.take(line); });
  if (table.points.size() < 2) {
    throw std::invalid_argument(path + ": " + std::to_string(table.points.size()) +
                                " points; expected at least 2");
  }
  return std::move(table.points);
}

}  // namespace cable_variation
