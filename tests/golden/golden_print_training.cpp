// Prints the hashes of trainings and calibrations, one "NAME SHA1" a line.
#include <cstdio>

#include "tests/golden/golden_hashes.h"

int main() {
  using namespace warplut;
  for (const GoldenHashes& hashes : {TrainingHashes(), CalibrationHashes()}) {
    for (const auto& [name, hash] : hashes) std::printf("%s %s\n", name.c_str(), hash.c_str());
  }
}
