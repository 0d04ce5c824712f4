#include <iostream>
#include <sstream>

#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tools/commands/command.h"

namespace warplut {
namespace {

// Standard output, where help goes, as long as it lives.
class CapturedOutput {
 public:
  CapturedOutput() : before_(std::cout.rdbuf(text_.rdbuf())) {}
  ~CapturedOutput() { std::cout.rdbuf(before_); }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  bool IsEmpty() const { return text_.view().empty(); }

 private:
  std::ostringstream text_;
  std::streambuf* before_;
};

// A command line of C has no byte 0 in an argument.
std::vector<std::string> ArgumentsOf(std::string_view bytes) {
  std::vector<std::string> arguments = {"warplut"};
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) arguments.emplace_back(line.c_str());
  return arguments;
}

}  // namespace

bool FuzzCommandLine(std::string_view bytes) {
  const std::vector<std::string> arguments = ArgumentsOf(bytes);
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const CapturedOutput output;
  CommandRun run;
  CommandLine command_line("warplut", "help", "version");
  for (const CommandAdder add : kCommands) add(command_line.program(), &run);
  bool parsed = false;
  const auto parse = [&] {
    parsed = command_line.Parse(static_cast<int>(argv.size()), argv.data());
  };
  if (!Accepts(parse)) return false;
  Require(parsed || !output.IsEmpty(), "a command line that is done prints nothing");
  return parsed && run != nullptr;
}

}  // namespace warplut
