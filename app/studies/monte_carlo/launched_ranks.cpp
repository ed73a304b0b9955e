// Detection of the launcher of this process, from its environment.
#include <cstdlib>

#include "app/studies/monte_carlo/ranks.hpp"

namespace tubeplan::app {

namespace {

int numberOf(const char* variable) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : 0;
}

}  // namespace

bool areRanksLaunched() {
  // Open MPI's mpirun; MPICH's and Intel's mpiexec.
  for (const char* size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (numberOf(size) > 1) return true;
  // srun gives every process of a step its rank; a batch script with many tasks that is one process itself is no step.
  return std::getenv("SLURM_PROCID") && std::getenv("SLURM_STEP_ID") && numberOf("SLURM_STEP_NUM_TASKS") > 1;
}

int ranksOnThisMachine() {
  for (const char* size : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "SLURM_TASKS_PER_NODE"})
    if (const int ranks = numberOf(size); ranks > 0) return ranks;
  return 1;
}

}  // namespace tubeplan::app
