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
std::string reportPage(const std::string& title, const std::vector<ReportFact>& about,
                       const std::vector<std::string>& warnings, const std::vector<ReportSection>& sections);

}  // namespace cable_variation
