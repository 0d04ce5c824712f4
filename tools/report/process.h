// Runs another program to its end.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace warplut {

struct ProcessResult {
  bool found = false;  // whether there is such a program
  int code = 0;        // exit code, or 128 + the signal that ended it
  std::string out;     // standard output
  std::string err;     // standard error
};

// Runs arguments[0], looked up in PATH, with `input` as its standard input, and waits. An Error
// names the program if the machine refuses: no process or no temporary file can be made.
ProcessResult RunProcess(const std::vector<std::string>& arguments, std::string_view input);

}  // namespace warplut
