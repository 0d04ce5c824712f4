// Prints the hashes of trainings, one "NAME SHA1" a line.
#include <cstdio>

#include "tests/golden/golden_hashes.h"

int main() {
  for (const auto& [name, hash] : warplut::TrainingHashes()) {
    std::printf("%s %s\n", name.c_str(), hash.c_str());
  }
}
