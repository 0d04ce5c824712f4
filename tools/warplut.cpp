// The program `warplut`: parses the command line, runs one subcommand, turns every failure into one
// sentence.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "tools/command.h"
#include "tools/interrupt.h"

namespace warplut {
namespace {

// Prints "warplut: SENTENCE" on standard error, in one line that ends with a full stop.
void PrintError(std::string sentence) {
  for (char& c : sentence) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  while (!sentence.empty() && sentence.back() == ' ') sentence.pop_back();
  if (sentence.empty()) sentence = "unknown error";
  if (sentence.back() != '.') sentence += '.';
  std::fprintf(stderr, "warplut: %s\n", sentence.c_str());
}

ExitCode Run(int argc, char** argv) {
  CLI::App app("Trains, bakes, judges and runs resampling lookup tables for image warps.",
               "warplut");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", "warplut " WARPLUT_VERSION);
  CommandRun run;
  for (const CommandAdder add : kCommands) add(app, &run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    app.exit(asked);
    return ExitCode::kDone;
  } catch (const CLI::ParseError& wrong) {
    PrintError(wrong.what());
    return ExitCode::kUsage;
  }
  RequireUsage(static_cast<bool>(run), "no command is given; 'warplut --help' lists them");
  InstallInterruptHandlers();
  return run();
}

ExitCode RunGuarded(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const UsageError& wrong) {
    PrintError(wrong.what());
    return ExitCode::kUsage;
  } catch (const std::bad_alloc&) {
    PrintError("there is not enough memory for this input");
  } catch (const std::exception& failure) {
    PrintError(failure.what());
  }
  return ExitCode::kFailed;
}

}  // namespace
}  // namespace warplut

int main(int argc, char** argv) { return static_cast<int>(warplut::RunGuarded(argc, argv)); }
