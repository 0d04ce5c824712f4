// Prints the hashes of baked files and modes, one "NAME SHA1" a line.
#include <cstdio>

#include "tests/golden/golden_hashes.h"

int main() {
  using namespace warplut;
  for (const GoldenHashes& hashes : {BakeHashes(), ModeHashes()}) {
    for (const auto& [name, hash] : hashes) std::printf("%s %s\n", name.c_str(), hash.c_str());
  }
}
