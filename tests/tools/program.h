// Runs the built program `warplut`, as a person or a script would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace warplut {

// Exit codes of `warplut`, as its documents promise them.
inline constexpr int kUsage = 1;
inline constexpr int kFailed = 2;
inline constexpr int kMissed = 3;

struct ProgramResult {
  int code = 0;  // exit code, or 128 + signal
  std::string out;
  std::string err;
};

struct ProgramSetup {
  std::string standard_output = {};        // a file to write to instead of a pipe
  long file_size_limit = 0;                // bytes that a file may have (a full disk); 0: no limit
  std::filesystem::path signal_when = {};  // once this exists, SIGINT is sent
  int signal_after = 0;  // milliseconds after SIGINT has a handler, it is sent; 0: not
};

ProgramResult RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                         const ProgramSetup& setup = {});
// JSON that a command prints is checked against docs/JSON.md.
ProgramResult RunWarplut(const std::vector<std::string>& arguments, const ProgramSetup& setup = {});

// `command`, then those of `defaults` (options with one value) that `more` does not name, then
// `more`.
std::vector<std::string> WithDefaults(
    std::vector<std::string> command,
    const std::vector<std::pair<std::string, std::string>>& defaults,
    const std::vector<std::string>& more);

// Expects the exit code, and exactly one sentence on standard error, "warplut: ...", that contains
// `piece`.
void ExpectRefused(const ProgramResult& result, int code, const std::string& piece);

}  // namespace warplut
