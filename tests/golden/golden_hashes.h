// Hashes of results whose bits are promised, by name.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace warplut {

// SHA-1, by name: "bake/FORMAT/KIND" of baked files, "mode/METHOD/INSTRUCTION SET" of what a method
// shows of a small clip. The clip is made of numbers that are exact in float, and so the same with
// every compiler.
using GoldenHashes = std::map<std::string, std::string>;

GoldenHashes BakeHashes();
// On each instruction set that this processor and build have.
GoldenHashes ModeHashes();
// "training/OBJECTIVE/INSTRUCTION SET", on the best instruction set of this processor.
GoldenHashes TrainingHashes();
// "calibration/METHOD/INSTRUCTION SET": the best and the kept parameters with their losses, on
// AVX2, or the best instruction set of a processor without it.
GoldenHashes CalibrationHashes();

}  // namespace warplut
