#pragma once  // internal to report/

namespace cable_variation {

/// The style sheet of every report: for wide and narrow screens, light and dark, and print on A4.
extern const char* const kPageStyle;

}  // namespace cable_variation
