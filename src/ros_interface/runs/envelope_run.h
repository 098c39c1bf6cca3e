#pragma once

#include <string>
#include <vector>

#include <cable_variation/GenerateEnvelope.h>

#include <cable_variation/analysis/envelope_calculation.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/display/envelope_publisher.h>
#include <ros_interface/runs/long_run.h>

namespace cable_variation_ros {

/// An envelope with its clearances, its surface and its files, which are written last: one that cannot be
/// written makes the answer's status IO_ERROR, and costs nothing else.
class EnvelopeRun : public LongRun {
 public:
  using Request = cable_variation::GenerateEnvelopeRequest;
  using Response = cable_variation::GenerateEnvelopeResponse;
  using Publisher = EnvelopePublisher;

  EnvelopeRun(Request request, RunLimits limits, EnvelopePublisher& publisher);

  void prepare(const SolverContext& context) override;
  const std::string& name() const override { return task_.name; }
  void calculate(cable_variation::RunControl& control) override;
  bool keepsWhatWasDone() const override { return false; }
  bool show(const SolverContext& context) override;
  void warn(const std::string& warning) override { response_.warnings.push_back(warning); }

  Response takeResponse() { return std::move(response_); }

 private:
  const cable_variation::Scene& scene() const { return snapshot_.design.scene; }
  void answer(const cable_variation::EnvelopeCalculation& found);
  void view(const cable_variation::EnvelopeCalculation& found);
  void write(const cable_variation::EnvelopeCalculation& found, cable_variation::RunControl& control);

  Request request_;
  RunLimits limits_;
  EnvelopePublisher& publisher_;
  cable_variation::EnvelopeTask task_;
  SolverContext::Snapshot snapshot_;
  Response response_;
  EnvelopeView view_;
};

}  // namespace cable_variation_ros
