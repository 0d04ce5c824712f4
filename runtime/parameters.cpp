#include "runtime/parameters.h"

#include <cstdio>

namespace warplut {

bool Parameters::IsValid(std::string* why) const {
  for (const ParameterInfo& info : kParameters) {
    const float value = this->*info.member;
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
