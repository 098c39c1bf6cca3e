#include <cable_variation/report/section.h>

#include <algorithm>
#include <cctype>

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

std::string className(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::doubtful:
      return "doubtful";
    case Tone::bad:
      return "bad";
    case Tone::plain:
      break;
  }
  return "plain";
}

/// Whether a column has words alone, no figures: those stand flush left.
bool hasWords(const ReportTable& table, std::size_t column) {
  bool any = false;
  for (const std::vector<ReportCell>& row : table.rows) {
    if (column >= row.size() || row[column].text.empty()) continue;
    const std::string& text = row[column].text;
    const bool is_word =
        std::isalpha(static_cast<unsigned char>(text[0])) != 0 || row[column].tone != Tone::plain;
    if (!is_word) return false;
    any = true;
  }
  return any;
}

std::string cellAttributes(const ReportCell& cell, bool words) {
  constexpr std::size_t kSentence = 40;  // bytes: longer than any figure
  std::string attributes;
  if (cell.tone != Tone::plain) {
    attributes += " class=\"" + className(cell.tone) + (words ? " words" : "") + "\"";
  } else if (cell.emphasis) {
    attributes += " class=\"out\"";
  } else if (cell.text.size() > kSentence) {
    attributes += " class=\"text\"";
  } else if (words) {
    attributes += " class=\"words\"";
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
  html_ += "<div class=\"scroll\"><table>\n";
  if (!table.caption.empty()) html_ += "<caption>" + escaped(table.caption) + "</caption>\n";
  html_ += "<thead><tr>";
  std::vector<bool> words;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    words.push_back(i > 0 && hasWords(table, i));
    html_ += std::string("<th scope=\"col\"") + (words[i] ? " class=\"words\"" : "") + ">" +
             withLineBreaks(table.columns[i]) + "</th>";
  }
  html_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<ReportCell>& row : table.rows) {
    html_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string tag = i == 0 ? "th" : "td";
      html_ += "<" + tag + (i == 0 ? " scope=\"row\"" : "") +
               cellAttributes(row[i], i < words.size() && words[i]) + ">" + escaped(row[i].text) + "</" +
               tag + ">";
    }
    html_ += "</tr>\n";
  }
  html_ += "</tbody>\n</table></div>\n";
}

void ReportSection::banner(Tone tone, const std::string& word, const std::string& text) {
  html_ += "<p class=\"banner " + className(tone) + "\"><strong>" + escaped(word) + "</strong> " +
           escaped(text) + "</p>\n";
}

void ReportSection::chart(const std::string& svg, const std::string& caption, Width width) {
  const char* const name = width == Width::third ? "third" : width == Width::half ? "half" : "full";
  html_ += std::string("<figure class=\"") + name + "\">\n" + svg + "<figcaption>" + escaped(caption) +
           "</figcaption>\n</figure>\n";
}

}  // namespace cable_variation
