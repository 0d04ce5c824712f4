// Prints the hashes, one "NAME SHA1" a line; with "--training" those of trainings too.
#include <cstdio>
#include <cstring>

#include "tests/golden/golden_hashes.h"

int main(int argc, char** argv) {
  using namespace warplut;
  const bool training = argc > 1 && std::strcmp(argv[1], "--training") == 0;
  for (const GoldenHashes& hashes :
       {BakeHashes(), ModeHashes(), training ? TrainingHashes() : GoldenHashes()}) {
    for (const auto& [name, hash] : hashes) std::printf("%s %s\n", name.c_str(), hash.c_str());
  }
}
