#include "runtime/parameters.h"

#include <cstdio>

#include "runtime/configuration/parameter_index.h"

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

int FindParameter(const std::string& name) { return ParameterIndex(name); }

std::string ParameterNames() {
  std::string names;
  for (const ParameterInfo& info : kParameters) {
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  return names;
}

}  // namespace warplut
