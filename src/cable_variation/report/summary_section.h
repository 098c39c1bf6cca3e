#pragma once  // internal to report/

#include <string>

#include <cable_variation/report/review.h>

namespace cable_variation {

/// The first page: what all of it comes to, the scene, the verdict on every measure and clearance, the
/// tolerances that went in.
ReportSection summarySection(const Review& review);

}  // namespace cable_variation
