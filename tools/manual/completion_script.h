// Completions of a command line for shells.
#pragma once

#include <string>
#include <vector>

#include "tools/manual/command_description.h"

namespace warplut {

// The shells that CompletionScript knows: bash, zsh, fish.
std::vector<std::string> CompletionShells();

// A script that completes commands, options, choices and files. How it is loaded: bash and fish
// source it, zsh finds it as _NAME in a folder of $fpath. `shell`: one of CompletionShells.
// A pure function of the description.
std::string CompletionScript(const std::string& shell, const CommandDescription& program);

}  // namespace warplut
