// The file that a target reads: in memory where the system has such a folder, without a sync.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "datasets/error.h"

namespace warplut {

// A folder of this process, removed at its end.
const std::filesystem::path& FuzzFolder();

// Writes `bytes` to the file of that name in FuzzFolder() and returns its path.
std::filesystem::path FuzzFile(const std::string& name, std::string_view bytes);

// Ends the program with the message unless `holds`.
void Require(bool holds, const std::string& message);

// Whether `read` ends without an Error. An Error must have a sentence.
bool Accepts(const std::function<void()>& read);

}  // namespace warplut
