#include "train/ranks/launch.h"

#include <cstdlib>
#include <initializer_list>

namespace warplut {
namespace {

int Count(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atoi(text);
}

}  // namespace

int LaunchedRanks() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    if (const int count = Count(variable); count > 0) return count;
  }
  // srun starts every program; only with an MPI plug-in does it start ranks.
  const bool pmix = std::getenv("PMIX_RANK") != nullptr;
  return pmix ? Count("SLURM_NTASKS") : 0;
}

}  // namespace warplut
