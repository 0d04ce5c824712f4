// The subcommands of `warplut dataset` that have a file of their own.
#pragma once

#include "tools/commands/command.h"

namespace warplut {

void AddInspectCommand(Command dataset, CommandRun* run);
void AddImportCommand(Command dataset, CommandRun* run);

}  // namespace warplut
