// Built where there is no MPI.
#include <command/rank_link.h>

#include <stdexcept>

#include <command/launched_ranks.h>

namespace cable_variation_command {

std::unique_ptr<RankLink> linkOfRanks() {
  const int size = launchedRanks();
  if (size == 1) return nullptr;
  throw std::invalid_argument(
      std::to_string(size) +
      " processes were started together, but this build has no MPI: expected one process, "
      "shards (--first_sample), or a build with libopenmpi-dev installed");
}

}  // namespace cable_variation_command
