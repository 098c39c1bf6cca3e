#pragma once

#include <vector>

#include <cable_variation/import/bundle_section.h>
#include <cable_variation/import/import_finding.h>
#include <cable_variation/import/import_mapping.h>
#include <cable_variation/import/kbl_document.h>
#include <cable_variation/rod/section.h>

namespace cable_variation {

/// What a segment is as a cable.
struct SegmentBundle {
  Section section;  ///< at the rule's sticking
  BundleBounds bounds;
  std::size_t wires = 0;  ///< routed through it, a multicore one counted once
};

/// Of all segments: wires of all modules together; tape and tubes by the share of the segment that they
/// cover, spread evenly, and by their weight alone where the mapping does not say how stiff they are. Wires
/// without a route or a mass, and segments without a cross-section, are among the findings.
std::vector<SegmentBundle> segmentBundles(const KblDocument& document, const ImportMapping& mapping,
                                          ImportFindings& findings);

}  // namespace cable_variation
