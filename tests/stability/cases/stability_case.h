// Stiff and extreme cases: what must happen, and what does. One registry that the tests and the
// report walk.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace warplut {

// kQuick takes at most a second or so: fewer frames, fewer random starts. kFull is what the report
// shows.
enum class StabilityEffort : std::uint8_t { kQuick, kFull };

struct StabilityResult {
  bool passed = false;
  std::string observed;  // the numbers behind it, in few words
};

struct StabilityCase {
  const char* group;     // "training", "gates", "gradients", "history", "runtime"
  const char* name;      // unique in its group, letters, digits, blanks and -_,.
  const char* required;  // the behaviour, with its bound
  StabilityResult (*run)(StabilityEffort effort);
  const char* failing = nullptr;  // known to fail: what the product does there, in a sentence
};

// One function for each group.
std::span<const StabilityCase> TrainingCases();
std::span<const StabilityCase> GateCases();
std::span<const StabilityCase> GradientCases();
std::span<const StabilityCase> HistoryCases();
std::span<const StabilityCase> RuntimeCases();

// All of them, in the order of the groups.
std::vector<StabilityCase> StabilityCases();

}  // namespace warplut
