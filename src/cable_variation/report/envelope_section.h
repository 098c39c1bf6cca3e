#pragma once

#include <string>
#include <vector>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/report/section.h>

namespace cable_variation {

/// An envelope to be reported on; what is referred to must outlive it.
struct EnvelopeFindings {
  const EnvelopeOptions& options;  ///< that it was made with
  const Envelope& envelope;
  const std::vector<EnvelopeClearance>& clearances;
  const TriangleMesh& surface;  ///< around all of it [m, world]
  double surface_excess = 0.0;  ///< of the surface beyond the envelope, at most [m]
  double volume = 0.0;          ///< within the surface [m³]
};

/// Volume, inflation and the like, each with what it is.
ReportTable envelopeTable(const EnvelopeFindings& found);

/// How sure the envelope is: what was found outside of it, and what can be concluded.
std::string containmentText(const Envelope& envelope);

/// The clearances, the closest first: what they are judged to be, the bound, the closest solved, the limit,
/// where and when.
ReportTable clearanceTable(const Scene& scene, const EnvelopeFindings& found);

/// The chapter of a report on an envelope: how sure it is, clearances, the closest places, snaps. Lengths in
/// mm, deviations in units a person reads.
ReportSection envelopeSection(const Scene& scene, const EnvelopeFindings& found);

}  // namespace cable_variation
