#pragma once

#include <string>

#include <cable_variation/analysis/output_directory.h>

namespace cable_variation {

/// Makes room for the files of an analysis: a page NAME.html of another kind of analysis, and the table
/// NAME.csv beside it, are kept as NAME_KIND.html and NAME_KIND.csv, KIND being that other kind in small
/// letters and _, such as stability_analysis. One of the same kind stays, to be replaced; so does what is no
/// report.
/// @param kind of what is to be written, as the page says it: "Stability analysis"
/// Throws FileError that names a file that cannot be kept.
void keepOtherReport(const OutputDirectory& output, const std::string& name, const std::string& kind);

}  // namespace cable_variation
