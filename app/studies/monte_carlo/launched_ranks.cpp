// Detection, from the environment, of a launcher that started this process.
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
  // Variables set by Open MPI's mpirun, and by mpiexec of MPICH and Intel MPI.
  for (const char* size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (numberOf(size) > 1) return true;
  // Under Slurm, srun sets a rank for every process of a job step. A process started by a batch script without srun
  // also has a rank, but its step has only one task.
  return std::getenv("SLURM_PROCID") && std::getenv("SLURM_STEP_ID") && numberOf("SLURM_STEP_NUM_TASKS") > 1;
}

int ranksOnThisMachine() {
  for (const char* size : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "SLURM_TASKS_PER_NODE"})
    if (const int ranks = numberOf(size); ranks > 0) return ranks;
  return 1;
}

}  // namespace tubeplan::app
