#pragma once

#include <string>
#include <vector>

namespace cable_variation::validation {

/// One figure of the program compared with one from elsewhere.
struct Check {
  std::string what;      ///< "tip of the 45° bend, P = 300 N"
  std::string expected;  ///< with its unit
  std::string found;     ///< likewise
  std::string error;     ///< likewise
  std::string source;    ///< of what is expected
};

/// A chapter: what was compared, and how.
struct Chapter {
  std::string title;
  std::string about;  ///< a paragraph
  std::vector<Check> checks;
  std::string left_out;  ///< why there are no checks; or empty
};

Chapter closedForms();
Chapter referenceSolutions();
Chapter publishedBenchmarks();
/// @param folder with white_1.csv to black_5.csv; empty: there are none
Chapter hangingWires(const std::string& folder);

}  // namespace cable_variation::validation
