#pragma once

#include <functional>
#include <vector>

#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/measures/section_loads.h>

namespace cable_variation {

/// What the measures of one solved scene have in common.
struct MeasureContext {
  const Scene& scene;
  const SolvedScene& at;
  std::vector<CableView> cables;

  /// Both must outlive the context.
  MeasureContext(const Scene& of, const SolvedScene& solved);

  /// Section forces and moments of a cable, per piece.
  const std::vector<SectionLoads>& loads(std::size_t cable) const;

 private:
  mutable std::vector<std::vector<SectionLoads>> loads_;  // per cable, made when first asked for
};

/// How a solved scene changes with one variable.
struct MeasureRates {
  const DesignRate& design;
  const EquilibriumRate& equilibrium;

  CableRates cable(std::size_t index) const;
};

/// The derivative of a measure by one variable after another; what they share is prepared. What it was made
/// from must outlive it.
using RateOfMeasure = std::function<double(const MeasureRates&)>;

/// A place that a measure names by its arc length: it keeps it when the cable changes, except at the
/// cable's ends (arc length 0 and the scene's length), where it stays at the end.
struct NamedPlace {
  Place place;
  bool at_end = false;

  NamedPlace(const MeasureContext& context, std::size_t cable, double arc_length);
  /// Change of its t.
  double shareRate(const CableView& view, const CableRates& rates) const;
};

/// `value` as the measure's, found at `place` on the centreline of a cable.
MeasureValue measureAt(const MeasureContext& context, std::size_t cable, const Place& place, double value);

/// Marks a value that another place has too.
void markAsShared(MeasureValue& value, const std::string& note);

}  // namespace cable_variation
