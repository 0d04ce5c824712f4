// Ranges of parameters, as lists of parameters declare them.
#pragma once

#include <cstdio>
#include <string>

namespace warplut {

// Whether each number of `parameters` is within its range; otherwise *why (if not null) names the
// first that is not. `list` has name, member, min and max of each; NaN is in no range.
template <typename Parameters, typename List>
bool AreInRange(const Parameters& parameters, const List& list, std::string* why) {
  for (const auto& info : list) {
    const float value = parameters.*info.member;
    if (value >= info.min && value <= info.max) continue;
    if (why != nullptr) {
      char sentence[160];
      std::snprintf(sentence, sizeof(sentence), "%s is %g; expected %g to %g.", info.name,
                    static_cast<double>(value), static_cast<double>(info.min),
                    static_cast<double>(info.max));
      *why = sentence;
    }
    return false;
  }
  return true;
}

}  // namespace warplut
