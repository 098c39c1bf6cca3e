#pragma once  // internal to measures/

#include <cmath>

#include <cable_variation/math/extremum.h>
#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

/// The largest of a quantity >= 0 along the measure's cables, and where. `quantityOn(cable)` gives it as a
/// function of piece and t.
template <class QuantityOn>
MeasureValue largestOver(const MeasureContext& context, const Measure& measure,
                         const QuantityOn& quantityOn) {
  constexpr double kSame = 1e-9;  // relative
  MeasureValue largest;
  double top = -1.0;
  bool shared = false;
  for (const std::size_t cable : measure.cables) {
    const Extremum found = largestAlong(context.cables[cable].pieces().size(), quantityOn(cable));
    if (std::abs(found.value - top) <= kSame * top) {
      shared = true;
    } else if (found.value > top) {
      shared = !found.unique;
    }
    if (found.value <= top) continue;
    top = found.value;
    largest = measureAt(context, cable, {found.piece, found.t}, top);
  }
  if (shared) markAsShared(largest, "the same at another place");
  return largest;
}

}  // namespace cable_variation
