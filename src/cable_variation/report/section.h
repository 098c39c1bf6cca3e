#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// How good something is, beside the word that says so.
enum class Tone { plain, good, doubtful, bad };

struct ReportCell {
  std::string text;
  double shade = 0.0;     ///< 0 white to 1 full
  bool emphasis = false;  ///< out of its limits
  Tone tone = Tone::plain;
};

/// Text alone.
inline ReportCell plain(const std::string& text) { return {text, 0.0, false}; }

struct ReportTable {
  std::string caption;
  std::vector<std::string> columns;           ///< headings; a line break for a unit below
  std::vector<std::vector<ReportCell>> rows;  ///< the first cell names the row
};

/// One chapter of a report, built from top to bottom. All texts are plain text.
class ReportSection {
 public:
  explicit ReportSection(const std::string& title);

  const std::string& title() const { return title_; }

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void warning(const std::string& text);
  void table(const ReportTable& table);
  /// What the reader is to see first. @param word in capitals @param text what it is about
  void banner(Tone tone, const std::string& word, const std::string& text);
  /// How much of the page's width a figure takes where that is wide enough.
  enum class Width { third, half, full };
  /// @param svg element made by a chart function
  void chart(const std::string& svg, const std::string& caption, Width width = Width::third);

  const std::string& html() const { return html_; }  ///< well-formed XHTML

 private:
  std::string title_;
  std::string html_;
};

}  // namespace cable_variation
