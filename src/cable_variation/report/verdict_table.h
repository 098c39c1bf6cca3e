#pragma once

#include <vector>

#include <cable_variation/report/section.h>
#include <cable_variation/report/verdict.h>

namespace cable_variation {

Tone toneOf(Verdict verdict);

/// The word, in its colour.
ReportCell verdictCell(Verdict verdict);

/// All measures: verdict, value at the design, limits, Cpk, worst case, share outside. What no measure has is
/// left out.
/// @param value what the value is of
ReportTable verdictTable(const Scene& scene, const std::vector<MeasureVerdict>& verdicts,
                         const std::string& value = "design");

/// Of the rows above: by what they are judged.
std::string verdictRule(const std::vector<MeasureVerdict>& verdicts);

}  // namespace cable_variation
