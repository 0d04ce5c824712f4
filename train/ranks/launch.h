// How many ranks this process was started with, as the launchers of MPI tell it.
#pragma once

namespace warplut {

// From the environment of Open MPI, of PMI (MPICH, Intel MPI) and of PMIx or Slurm's srun --mpi; 0
// if no launcher started this process.
int LaunchedRanks();

}  // namespace warplut
