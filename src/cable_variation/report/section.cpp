#include <cable_variation/report/section.h>

#include <algorithm>

#include <cable_variation/report/markup.h>

namespace cable_variation {

namespace {

std::string withLineBreaks(const std::string& text) {
  std::string html = escaped(text);
  for (std::size_t at = html.find('\n'); at != std::string::npos; at = html.find('\n', at)) {
    html.replace(at, 1, "<br/>");
  }
  return html;
}

std::string cellAttributes(const ReportCell& cell) {
  constexpr std::size_t kSentence = 40;  // bytes: longer than any figure
  std::string attributes;
  if (cell.emphasis) {
    attributes += " class=\"out\"";
  } else if (cell.text.size() > kSentence) {
    attributes += " class=\"text\"";
  }
  if (cell.shade > 0.0) {
    attributes += " style=\"background:rgba(38,120,178," + figure(0.6 * std::min(cell.shade, 1.0), 2) + ")\"";
  }
  return attributes;
}

}  // namespace

ReportSection::ReportSection(const std::string& title) : title_(title) {}

void ReportSection::heading(const std::string& text) { html_ += "<h3>" + escaped(text) + "</h3>\n"; }

void ReportSection::paragraph(const std::string& text) { html_ += "<p>" + escaped(text) + "</p>\n"; }

void ReportSection::warning(const std::string& text) { html_ += warningHtml(text); }

void ReportSection::table(const ReportTable& table) {
  html_ += "<table>\n";
  if (!table.caption.empty()) html_ += "<caption>" + escaped(table.caption) + "</caption>\n";
  html_ += "<thead><tr>";
  for (const std::string& column : table.columns) {
    html_ += "<th scope=\"col\">" + withLineBreaks(column) + "</th>";
  }
  html_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<ReportCell>& row : table.rows) {
    html_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string tag = i == 0 ? "th" : "td";
      html_ += "<" + tag + (i == 0 ? " scope=\"row\"" : "") + cellAttributes(row[i]) + ">" +
               escaped(row[i].text) + "</" + tag + ">";
    }
    html_ += "</tr>\n";
  }
  html_ += "</tbody>\n</table>\n";
}

void ReportSection::chart(const std::string& svg, const std::string& caption) {
  html_ += "<figure>\n" + svg + "<figcaption>" + escaped(caption) + "</figcaption>\n</figure>\n";
}

}  // namespace cable_variation
