#pragma once

#include <functional>
#include <string>

#include <cable_variation/SimulateVariation.h>

#include <cable_variation/simulation/simulation.h>
#include <ros_interface/node/output_directory.h>

namespace cable_variation_ros {

class NameRegistry;
class SolverContext;
class SpinningThread;
class VariationPublisher;

/// Simulates production for the service and the action, on threads of its own: the node answers meanwhile.
class SimulationRunner {
 public:
  /// @param threads for each run; 0: as many as there are cores @param memory_limit for each run [B]
  SimulationRunner(SolverContext& context, VariationPublisher& publisher, SpinningThread& spinning,
                   const OutputDirectory& output, NameRegistry& names, std::size_t threads,
                   double memory_limit);

  /// Told how far a run is, now and then, with the names of the measures; false: cancel it.
  using Watcher =
      std::function<bool(const cable_variation::SimulationProgress&, const std::vector<std::string>&)>;

  /// Not from the spinning thread. The answer's status tells how it ended; cancelled, it has what was done.
  cable_variation::SimulateVariationResponse run(const cable_variation::SimulateVariationRequest& request,
                                                 const Watcher& watcher);

 private:
  cable_variation::SimulateVariationResponse complete(
      const cable_variation::SimulateVariationRequest& request, const Watcher& watcher);

  SolverContext& context_;
  VariationPublisher& publisher_;
  SpinningThread& spinning_;
  OutputDirectory output_;
  NameRegistry& names_;
  std::size_t threads_;
  double memory_limit_;
};

}  // namespace cable_variation_ros
