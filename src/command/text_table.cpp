#include <command/text_table.h>

#include <algorithm>
#include <sstream>

#include <cable_variation/util/utf8.h>

namespace cable_variation_command {

using cable_variation::ReportCell;
using cable_variation::ReportTable;

namespace {

constexpr std::size_t kWidth = 100;  // of text, in characters
constexpr std::size_t kGap = 2;

/// In characters.
std::size_t widthOf(const std::string& text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size(); ++at) width += cable_variation::continuesUtf8(text, at) ? 0 : 1;
  return width;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

using Row = std::vector<std::string>;

/// Whether it is more than a figure with its unit: some words.
bool isSentence(const std::string& text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return std::count(text.begin(), text.end(), ' ') > 1 && std::any_of(text.begin(), text.end(), letter);
}

/// The headings, a row for each line of the tallest.
std::vector<Row> headingsOf(const ReportTable& table) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::vector<std::string> lines = linesOf(table.columns[i]);
    while (rows.size() < lines.size()) rows.emplace_back(table.columns.size());
    for (std::size_t k = 0; k < lines.size(); ++k) rows[k][i] = lines[k];
  }
  return rows;
}

}  // namespace

std::string tableText(const ReportTable& table) {
  std::vector<Row> rows = headingsOf(table);
  for (const std::vector<ReportCell>& cells : table.rows) {
    Row row;
    for (const ReportCell& cell : cells) row.push_back(cell.text);
    rows.push_back(row);
  }
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
  }
  std::vector<bool> left(widths.size(), false);
  for (const std::vector<ReportCell>& cells : table.rows) {
    for (std::size_t i = 0; i < cells.size(); ++i) left[i] = left[i] || i == 0 || isSentence(cells[i].text);
  }
  std::string text = table.caption.empty() ? "" : wrapped(table.caption);
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - widthOf(row[i]), ' ');
      line += std::string(kGap, ' ') + (left[i] ? row[i] + blanks : blanks + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string wrapped(const std::string& text) {
  std::string lines, line;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) {
    if (!line.empty() && widthOf(line) + 1 + widthOf(word) > kWidth) {
      lines += line + "\n";
      line = " ";
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + line + "\n";
}

}  // namespace cable_variation_command
