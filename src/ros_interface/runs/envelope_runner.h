#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include <cable_variation/GenerateEnvelope.h>

#include <ros_interface/node/output_directory.h>
#include <ros_interface/runs/background_run.h>

namespace cable_variation_ros {

class EnvelopePublisher;
class NameRegistry;
class SolverContext;
class SpinningThread;

/// Makes envelopes for the service and the action, on threads of its own: the node answers meanwhile.
class EnvelopeRunner {
 public:
  /// @param threads for each run; 0: as many as there are cores @param memory_limit for each run [B]
  EnvelopeRunner(SolverContext& context, EnvelopePublisher& publisher, SpinningThread& spinning,
                 const OutputDirectory& output, NameRegistry& names, std::size_t threads,
                 double memory_limit);

  /// Told how far a run is, now and then; false: cancel it.
  using Watcher = std::function<bool(const RunProgress&)>;

  /// Not from the spinning thread. The answer's status tells how it ended; IO_ERROR comes with all of the
  /// answer but the paths of the files that could not be written. Unless it is that or SUCCESS there is
  /// nothing else, no file and nothing new to be seen. Returns within some 20 ms of being cancelled.
  cable_variation::GenerateEnvelopeResponse run(const cable_variation::GenerateEnvelopeRequest& request,
                                                const Watcher& watcher);

 private:
  cable_variation::GenerateEnvelopeResponse complete(const cable_variation::GenerateEnvelopeRequest& request,
                                                     const Watcher& watcher);
  void leave(std::unique_ptr<BackgroundRun> cancelled);

  SolverContext& context_;
  EnvelopePublisher& publisher_;
  SpinningThread& spinning_;
  OutputDirectory output_;
  NameRegistry& names_;
  std::size_t threads_;
  double memory_limit_;
  std::mutex mutex_;
  std::list<std::unique_ptr<BackgroundRun>> cancelled_;  ///< that have not noticed yet
};

}  // namespace cable_variation_ros
