#pragma once

#include <string>
#include <vector>

#include <cable_variation/CableEvent.h>

#include <cable_variation/tracking/shape_event.h>

namespace cable_variation_ros {

class SolverContext;

/// Tells what happened to the shape in force from one change to the next: snaps, an equilibrium lost and
/// found, limits of measures broken and kept again, clips closed and opened.
class ShapeWatch {
 public:
  /// @param measured all measures; none without an equilibrium
  std::vector<cable_variation::CableEvent> eventsOf(
      const SolverContext& context, const std::vector<cable_variation::MeasureValue>& measured);

  /// What eventsOf() told last.
  const std::vector<cable_variation::CableEvent>& lastEvents() const { return last_; }

 private:
  std::vector<cable_variation::CableEvent> last_;
  bool converged_ = true;
  std::string source_;  // of the scene
  cable_variation::LimitWatch limits_;
};

}  // namespace cable_variation_ros
