// The options that commands with a pipeline share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/commands/command_line.h"
#include "tools/pipeline.h"

namespace warplut {

// Adds --lut, --lookup and --threads.
void AddTableOptions(Command command, PipelineArguments* arguments);

// Adds --streams-below.
void AddStreamsBelowOption(Command command, std::string* folder);

// Adds --streams-below, --params, --filter, --frames, --generated, --alpha, --motion-filter,
// --history and --texels.
void AddPipelineOptions(Command command, PipelineArguments* arguments);

// Adds --device and returns it.
CommandOption AddDeviceOption(Command command, std::string* device);

// Adds --settled and returns it.
CommandOption AddSettledOption(Command command, int* settled);

}  // namespace warplut
