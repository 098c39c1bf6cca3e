#pragma once  // internal to report/

#include <string>

namespace cable_variation {

/// Text as content or attribute of XHTML: markup characters escaped, what XML cannot hold (control
/// characters, bytes that are no UTF-8) replaced by U+FFFD.
std::string escaped(const std::string& text);

/// A paragraph that stands out, as XHTML. @param text plain
std::string warningHtml(const std::string& text);

/// A figure for a person, to `digits` significant ones, without trailing zeros; not a number: a dash.
std::string figure(double value, int digits = 4);

std::string millimetres(double metres, int digits = 4);  ///< a figure, without its unit

std::string percent(double share);  ///< to three figures

/// A share of production that is no good: a small one in parts per million too, a very small one in these
/// alone. Of one that never comes the digits would mean nothing.
std::string rejectText(double share);

}  // namespace cable_variation
