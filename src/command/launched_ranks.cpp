#include <command/launched_ranks.h>

#include <algorithm>
#include <cstdlib>

namespace cable_variation_command {

int launchedRanks() {
  // of Open MPI's mpirun, of MPICH's and Intel's, of Slurm's srun with PMIx
  if (const char* const size = std::getenv("OMPI_COMM_WORLD_SIZE")) return std::max(1, std::atoi(size));
  if (const char* const size = std::getenv("PMI_SIZE")) return std::max(1, std::atoi(size));
  if (std::getenv("PMIX_RANK") != nullptr) {
    const char* const tasks = std::getenv("SLURM_STEP_NUM_TASKS");
    if (tasks != nullptr) return std::max(1, std::atoi(tasks));
  }
  return 1;
}

}  // namespace cable_variation_command
