#pragma once

namespace cable_variation_command {

/// How many processes were started together, as launchers of MPI tell them in the environment; 1: this alone.
int launchedRanks();

}  // namespace cable_variation_command
