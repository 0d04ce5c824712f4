#include "runtime/parameters.h"

#include "runtime/configuration/parameter_index.h"
#include "runtime/core/parameter_range.h"

namespace warplut {

bool Parameters::IsValid(std::string* why) const { return AreInRange(*this, kParameters, why); }

int FindParameter(const std::string& name) { return ParameterIndex(name); }

std::string ParameterNames() {
  std::string names;
  for (const ParameterInfo& info : kParameters) {
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  }
  return names;
}

}  // namespace warplut
