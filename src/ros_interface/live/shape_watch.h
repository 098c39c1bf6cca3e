#pragma once

#include <string>
#include <vector>

#include <cable_variation/CableEvent.h>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation_ros {

class SolverContext;

/// Tells what happened to the shape in force from one change to the next: snaps, an equilibrium lost and
/// found, limits of measures broken and kept again.
class ShapeWatch {
 public:
  /// @param measured all measures; none without an equilibrium
  std::vector<cable_variation::CableEvent> eventsOf(
      const SolverContext& context, const std::vector<cable_variation::MeasureValue>& measured);

  /// What eventsOf() told last.
  const std::vector<cable_variation::CableEvent>& lastEvents() const { return last_; }

 private:
  void compareEquilibria(const SolverContext& context, std::vector<cable_variation::CableEvent>& events);
  void compareLimits(const SolverContext& context, const std::vector<cable_variation::MeasureValue>& measured,
                     std::vector<cable_variation::CableEvent>& events);

  std::vector<cable_variation::CableEvent> last_;
  bool converged_ = true;
  std::string source_;  // of the scene
  struct Known {
    double value = 0.0;
    bool within = true;
  };
  std::vector<Known> known_;  // per measure, when there last was an equilibrium
};

}  // namespace cable_variation_ros
