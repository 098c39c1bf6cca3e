#pragma once

#include <string>

#include <cable_variation/report/review.h>
#include <cable_variation/report/verdict.h>

namespace cable_variation {

/// What a review knows of its measures, for verdictsOf(); refers to the review.
MeasureEvidence evidenceOf(const Review& review);

/// The first page: what all of it comes to, the scene, the verdict on every measure and clearance, the
/// tolerances that went in.
ReportSection summarySection(const Review& review);

}  // namespace cable_variation
