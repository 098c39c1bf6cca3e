#pragma once  // internal to envelope/

#include <cstddef>
#include <mutex>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/harness/topology.h>
#include <cable_variation/tolerances/sample_space.h>

namespace cable_variation {

/// How far along a cable its material can be from where a clip holds it, over the harnesses of an envelope:
/// lengths vary, and what holds a cable may slide on it. May be told by several threads; what is known in
/// the end does not depend on their order.
class ClipOffsets {
 public:
  /// Knows the design, and what the tolerances do to lengths and places, each variable by itself and all
  /// together (they act linearly). How far clips slide on it is not known yet.
  /// @param start the design, solved as `equilibrium`
  ClipOffsets(const SampleSpace& space, const SamplePlace& start, const Equilibrium& equilibrium);

  void add(const Harness& harness, const Equilibrium& equilibrium);

  /// The largest way along the cable between a clip of it and a material place [m].
  /// @param nominal its arc length in the design [m]
  double largest(std::size_t clip, double nominal) const;

  /// The nominal arc lengths on both sides of a clip [m] up to which the way is at most `near` [m] in all
  /// harnesses; none where the cable ends before.
  std::vector<double> placesWithin(std::size_t clip, double near) const;

 private:
  struct Range {
    double low = 0.0, high = 0.0;
  };
  std::vector<double> arcLengths(const Harness& harness, const Equilibrium* equilibrium) const;

  Harness design_;
  Topology topology_;
  std::vector<double> nominal_;             // per station [m]
  std::vector<std::vector<Range>> ranges_;  // per clip: of each station of its cable, from the clip [m]
  bool comparable_ = true;                  // whether all harnesses have had the design's stations
  mutable std::mutex mutex_;
};

}  // namespace cable_variation
