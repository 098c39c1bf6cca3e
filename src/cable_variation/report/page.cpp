#include <cable_variation/report/page.h>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/page_style.h>

namespace cable_variation {

namespace {

// before what may be long
const std::string kKindStart = "<meta name=\"cable_variation-report\" content=\"", kKindEnd = "\"/>\n";

std::string anchor(std::size_t index) { return "section-" + std::to_string(index + 1); }

}  // namespace

std::string reportPage(const std::string& title, const std::vector<ReportFact>& about,
                       const std::vector<std::string>& warnings, const std::vector<ReportSection>& sections,
                       const std::string& kind) {
  std::string html =
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n" +
      (kind.empty() ? std::string() : kKindStart + escaped(kind) + kKindEnd) +
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n<meta "
      "name=\"color-scheme\" content=\"light dark\"/>\n<title>" +
      escaped(title) + "</title>\n<style>" + kPageStyle + "</style>\n</head>\n<body>\n<h1>" + escaped(title) +
      "</h1>\n";
  if (!about.empty()) {
    html += "<dl class=\"about\">\n";
    for (const ReportFact& fact : about) {
      html += "<dt>" + escaped(fact.name) + "</dt><dd>" + escaped(fact.text) + "</dd>\n";
    }
    html += "</dl>\n";
  }
  for (const std::string& warning : warnings) html += warningHtml(warning);
  if (sections.size() > 1) {
    html += "<nav><ol>\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
      html += "<li><a href=\"#" + anchor(i) + "\">" + escaped(sections[i].title()) + "</a></li>\n";
    }
    html += "</ol></nav>\n";
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += "<section id=\"" + anchor(i) + "\">\n<h2>" + escaped(sections[i].title()) + "</h2>\n" +
            sections[i].html() + "</section>\n";
  }
  return html + "</body>\n</html>\n";
}

std::string reportKind(const std::string& page) {
  const std::size_t mark = page.find(kKindStart);
  if (mark == std::string::npos) return "";
  const std::size_t start = mark + kKindStart.size(), end = page.find(kKindEnd, start);
  return end == std::string::npos ? "" : page.substr(start, end - start);
}

}  // namespace cable_variation
