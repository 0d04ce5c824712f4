// The completion of each shell, for completion_script.cpp.
#pragma once

#include <string>

#include "tools/manual/command_description.h"

namespace warplut {

std::string BashCompletion(const CommandDescription& program);
std::string ZshCompletion(const CommandDescription& program);
std::string FishCompletion(const CommandDescription& program);

}  // namespace warplut
