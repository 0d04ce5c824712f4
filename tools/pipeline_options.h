// The options that commands with a pipeline share.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tools/pipeline.h"

namespace warplut {

// Adds --lut, --lookup and --threads.
void AddTableOptions(CLI::App& command, PipelineArguments* arguments);

// Adds --params, --filter, --frames, --generated, --alpha, --motion-filter, --history and --texels.
void AddPipelineOptions(CLI::App& command, PipelineArguments* arguments);

// Adds --settled and returns it.
CLI::Option* AddSettledOption(CLI::App& command, int* settled);

// The reader of a sequence for a command: the manifest, and a warning where the LUT was fitted for another scale.
Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path);

}  // namespace warplut
