#pragma once

#include <optional>
#include <string>

#include <cable_variation/SimulateVariation.h>

#include <cable_variation/analysis/simulation_task.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/display/variation_publisher.h>
#include <ros_interface/display/view_origin.h>
#include <ros_interface/markers/simulation_markers.h>
#include <ros_interface/runs/long_run.h>

namespace cable_variation_ros {

/// Production simulated, with its files. The answer's status is CANCELLED when it was ended before, IO_ERROR
/// when a file could not be written, with all the figures of what was done.
class SimulationRun : public LongRun {
 public:
  using Request = cable_variation::SimulateVariationRequest;
  using Response = cable_variation::SimulateVariationResponse;
  using Publisher = VariationPublisher;

  SimulationRun(Request request, RunLimits limits, VariationPublisher& publisher);

  void prepare(const SolverContext& context) override;
  const std::string& name() const override { return task_.name; }
  void calculate(cable_variation::RunControl& control) override;
  bool keepsWhatWasDone() const override { return true; }
  bool show(const SolverContext& context) override;
  void warn(const std::string& warning) override { response_.warnings.push_back(warning); }

  Response takeResponse() { return std::move(response_); }

 private:
  Request request_;
  RunLimits limits_;
  VariationPublisher& publisher_;
  cable_variation::SimulationTask task_;
  VariationFigure show_ = VariationFigure::six_sigma;
  SolverContext::Snapshot snapshot_;
  std::optional<cable_variation::MeasureEvaluator> evaluator_;
  Response response_;
  SimulationView view_;  ///< no markers: too few samples to show how cables vary
  ViewOrigin origin_;
};

}  // namespace cable_variation_ros
