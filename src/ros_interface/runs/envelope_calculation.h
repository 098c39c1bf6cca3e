#pragma once

#include <cable_variation/GenerateEnvelope.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/display/envelope_publisher.h>
#include <ros_interface/node/output_directory.h>
#include <ros_interface/runs/background_run.h>
#include <ros_interface/runs/envelope_task.h>

namespace cable_variation_ros {

struct EnvelopeOutcome {
  cable_variation::GenerateEnvelopeResponse response;  ///< IO_ERROR with the rest: a file
  EnvelopeView view;
};

/// An envelope with its clearances, its surface, its files and what is to be seen of it. Touches nothing but
/// the files, which are written last: what cannot be written is told in the status, and costs nothing else.
/// Throws what generateEnvelope() does, cable_variation::Cancelled when `control` says so.
EnvelopeOutcome calculateEnvelope(const EnvelopeTask& task, const SolverContext::Snapshot& snapshot,
                                  const OutputDirectory& output, RunControl& control);

}  // namespace cable_variation_ros
