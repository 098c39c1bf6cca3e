#pragma once

#include <string>
#include <vector>

#include <cable_variation/report/section.h>

namespace cable_variation_command {

/// A table of a report as lines of text: its caption, its headings, then its rows; columns as wide as they
/// need to be, the first and those with sentences flush left.
std::string tableText(const cable_variation::ReportTable& table);

/// Lines of at most 100 characters, broken at blanks; further ones are indented.
std::string wrapped(const std::string& text);

}  // namespace cable_variation_command
