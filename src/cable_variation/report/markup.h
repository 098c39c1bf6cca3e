#pragma once  // internal to report/

#include <string>

namespace cable_variation {

/// Text as content or attribute of XHTML: markup characters escaped, control characters (which XML cannot
/// hold) replaced by U+FFFD.
std::string escaped(const std::string& text);

/// A paragraph that stands out, as XHTML. @param text plain
std::string warningHtml(const std::string& text);

/// A figure for a person, to `digits` significant ones, without trailing zeros; not a number: a dash.
std::string figure(double value, int digits = 4);

std::string percent(double share);  ///< to three figures

/// The unit in which a person reads a quantity: mm for m, degrees for rad, others as they are.
struct ShownUnit {
  std::string name;     ///< empty: dimensionless
  double factor = 1.0;  ///< shown = factor × SI
};
ShownUnit shownUnit(const std::string& si_unit);

}  // namespace cable_variation
