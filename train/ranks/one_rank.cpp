// Ranks of a build without MPI: this process alone.
#include "datasets/error.h"
#include "train/ranks/launch.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

const Ranks* started = nullptr;

}  // namespace

Ranks::Ranks() {
  if (LaunchedRanks() > 1) {
    throw Error(
        "this program was built without MPI, so that its ranks would each do the whole work; "
        "expected a build that found MPI, or a start without mpirun.");
  }
}

Ranks::~Ranks() = default;

Ranks& Ranks::World() {
  static Ranks world;
  started = &world;
  return world;
}

const Ranks* Ranks::Started() { return started; }

void Ranks::Meet() {}
void Ranks::WaitForRoot() {}
bool Ranks::Any(bool here) { return here; }
double Ranks::OfRoot(double value) { return value; }
void Ranks::Exchange(std::span<const int>, std::vector<std::vector<double>>&) {}
void Ranks::RequireSame(const std::string&, const std::string&) {}
void Ranks::Abort(int) const {}

}  // namespace warplut
