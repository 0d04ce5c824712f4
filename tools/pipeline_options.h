// The options that commands with a pipeline share.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/command_line.h"
#include "tools/pipeline.h"

namespace warplut {

// Adds --lut, --lookup and --threads.
void AddTableOptions(Command command, PipelineArguments* arguments);

// Adds --params, --filter, --frames, --generated, --alpha, --motion-filter, --history and --texels.
void AddPipelineOptions(Command command, PipelineArguments* arguments);

// Adds --device and returns it.
CommandOption AddDeviceOption(Command command, std::string* device);

// Adds --settled and returns it.
CommandOption AddSettledOption(Command command, int* settled);

// Reads the sequence for a command that runs these methods: the manifest, and a warning where the
// LUT was fitted for another scale and one of them keeps a history, whose warps depend on the
// scale.
Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path,
                         const std::vector<const MethodInfo*>& methods);

}  // namespace warplut
