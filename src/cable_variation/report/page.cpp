#include <cable_variation/report/page.h>

#include <cable_variation/report/markup.h>

namespace cable_variation {

namespace {

constexpr char kStyle[] = R"(
body { font: 15px/1.5 sans-serif; color: #16181d; background: #fff; max-width: 80em; margin: 2em auto; padding: 0 1.5em; }
h1 { font-size: 1.9em; line-height: 1.2; margin: 0 0 .3em; }
h2 { font-size: 1.4em; border-bottom: 2px solid #2678b2; padding-bottom: .15em; margin-top: 2em; }
h3 { font-size: 1.1em; margin: 1.6em 0 .4em; }
.about { color: #555b66; margin: 0; overflow-wrap: anywhere; }
table { display: block; max-width: 100%; overflow-x: auto; border-collapse: collapse; margin: .8em 0; font-size: .88em; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: #555b66; padding-bottom: .3em; }
th, td { padding: .25em .7em; border-bottom: 1px solid #d5d9e0; text-align: right; vertical-align: bottom; white-space: nowrap; }
th:first-child, td.text { text-align: left; }
td.text { white-space: normal; min-width: 24em; vertical-align: top; }
p { max-width: 62em; }
thead th { border-bottom: 2px solid #16181d; }
tbody th { font-weight: normal; }
.out { color: #b00020; font-weight: bold; }
.warning { background: #fff4d6; border-left: 4px solid #d99a00; padding: .5em .8em; }
figure { margin: .8em 0; display: inline-block; vertical-align: top; break-inside: avoid; }
figcaption { font-size: .85em; color: #555b66; }
svg text { font: 12px sans-serif; fill: #16181d; }
@media print {
  body { font-size: 10pt; margin: 0; max-width: none; padding: 0; }
  table { overflow-x: visible; font-size: 7pt; }
  th, td { white-space: normal; padding: .25em .4em; }
  td.text { min-width: 0; }
  h2, h3, caption { break-after: avoid; }
  tr { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
@page { size: A4; margin: 16mm; }
)";

std::string anchor(std::size_t index) { return "section-" + std::to_string(index + 1); }

}  // namespace

std::string reportPage(const std::string& title, const std::vector<std::string>& about,
                       const std::vector<std::string>& warnings, const std::vector<ReportSection>& sections) {
  std::string html =
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
      escaped(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + escaped(title) +
      "</h1>\n";
  for (const std::string& line : about) html += "<p class=\"about\">" + escaped(line) + "</p>\n";
  for (const std::string& warning : warnings) html += warningHtml(warning);
  if (sections.size() > 1) {
    html += "<ol>\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
      html += "<li><a href=\"#" + anchor(i) + "\">" + escaped(sections[i].title()) + "</a></li>\n";
    }
    html += "</ol>\n";
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += "<section id=\"" + anchor(i) + "\">\n<h2>" + escaped(sections[i].title()) + "</h2>\n" +
            sections[i].html() + "</section>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace cable_variation
