// Manual pages of a command line, in roff with the macros of man(7).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/manual/command_description.h"

namespace warplut {

struct ManualPage {
  std::string name;  // of the file: "warplut-dataset-render.1"
  std::string text;
};

// A page for the program and one for each command below it. `version`: of the program;
// `exit_meanings`: a sentence for each exit code, from 0 on. A pure function: no date is in it.
std::vector<ManualPage> ManualPages(const CommandDescription& program, const std::string& version,
                                    const std::vector<std::string>& exit_meanings);

// Writes the pages into `folder`, each atomically, and returns their paths. An Error names what
// could not be written.
std::vector<std::filesystem::path> WriteManual(const std::filesystem::path& folder,
                                               const std::vector<ManualPage>& pages);

}  // namespace warplut
