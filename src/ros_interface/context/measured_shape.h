#pragma once

#include <optional>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation_ros {

class SolverContext;

/// All measures of the shape in force, evaluated once for all who ask. A similarity is that to the scene as
/// it was loaded, SolverContext::asLoaded(), so that it tells of every edit and every move; without such an
/// equilibrium it is not a number.
class MeasuredShape {
 public:
  /// @param context must outlive this
  explicit MeasuredShape(const SolverContext& context) : context_(context) {}

  /// The harness or its shape has changed.
  void contextChanged() { current_ = false; }

  /// One per measure of the scene; none without an equilibrium.
  const std::vector<cable_variation::MeasureValue>& values();

 private:
  void prepare();

  const SolverContext& context_;
  std::optional<cable_variation::MeasureEvaluator> evaluator_;
  bool has_nominal_ = false;       ///< for similarities
  std::size_t design_number_ = 0;  ///< that the evaluator is for
  std::vector<std::size_t> all_;
  std::vector<cable_variation::MeasureValue> values_;
  bool current_ = false;
};

}  // namespace cable_variation_ros
