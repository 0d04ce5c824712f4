// Runs the built program `warplut`, as a person or a script would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace warplut {

struct ProgramResult {
  int code = 0;  // exit code, or 128 + signal
  std::string out;
  std::string err;
};

struct ProgramSetup {
  std::string standard_output;        // a file to write to instead of a pipe
  long file_size_limit = 0;           // bytes that a file may have (a full disk); 0: no limit
  std::filesystem::path signal_when;  // once this exists, SIGINT is sent
  int signal_after = 0;               // milliseconds after SIGINT has a handler, it is sent; 0: not
};

ProgramResult RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                         const ProgramSetup& setup = {});
ProgramResult RunWarplut(const std::vector<std::string>& arguments, const ProgramSetup& setup = {});

// Expects the exit code, and exactly one sentence on standard error, "warplut: ...", that contains
// `piece`.
void ExpectRefused(const ProgramResult& result, int code, const std::string& piece);

}  // namespace warplut
