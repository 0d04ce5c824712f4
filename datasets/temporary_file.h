// Names of files that are being written, and those that a killed process left behind.
#pragma once

#include <filesystem>

namespace warplut {

// A new name beside `path`, with its extension: ".STEM.MACHINE-PROCESS-NUMBER.tmp.EXTENSION".
// Hidden, so that nothing that lists a folder's images takes it. Shorter than the longest name that
// systems take wherever the name of `path` is not longer itself. MACHINE stands for the host and
// its space of process numbers.
std::filesystem::path TemporaryBeside(const std::filesystem::path& path);

// Removes the files in `folder` ("": the working folder) that TemporaryBeside named for processes
// of this machine which are gone. Each process looks into a folder once. Errors are passed over: a
// file that stays does no harm.
void RemoveStaleTemporaries(const std::filesystem::path& folder);

}  // namespace warplut
