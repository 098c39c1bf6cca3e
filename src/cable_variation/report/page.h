#pragma once

#include <string>
#include <vector>

#include <cable_variation/report/section.h>

namespace cable_variation {

/// A line at the head of a report: "Scene", "harness.yaml".
struct ReportFact {
  std::string name, text;
};

/// A self-contained page (well-formed XHTML, which every browser reads as HTML too): warnings, contents, then
/// the sections in order. Nothing is loaded from elsewhere; dark where the reader's system is; prints on A4.
/// @param about under the title: scene, date, what was asked for
/// @param warnings of all that follows, such as implausible values in the scene
/// @param kind of what it is of, for programs: "Stability analysis"; empty: none
std::string reportPage(const std::string& title, const std::vector<ReportFact>& about,
                       const std::vector<std::string>& warnings, const std::vector<ReportSection>& sections,
                       const std::string& kind = "");

/// The kind that a page was given, of its text or the first 1000 bytes of that; empty: none, or no page.
std::string reportKind(const std::string& page);

}  // namespace cable_variation
