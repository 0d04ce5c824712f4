// The program `warplut`: parses the command line, runs one subcommand, turns every failure into one
// sentence.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <thread>

#include "runtime/warp.h"
#include "tools/commands/command.h"
#include "tools/terminal/interrupt.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

// The commands whose work ranks share.
constexpr std::string_view kShared[] = {"train", "calibrate", "dataset",
                                        "judge", "profile",   "report"};

// Prints "warplut: SENTENCE" on standard error, in one line that ends with a full stop. Text of a
// file that is in it cannot control a terminal, nor fill it.
void PrintError(std::string sentence) {
  constexpr std::size_t kLongest = 8192;  // bytes, more than two of the longest paths
  if (sentence.size() > kLongest) sentence = sentence.substr(0, kLongest) + "...";
  for (char& c : sentence) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  }
  while (!sentence.empty() && sentence.back() == ' ') sentence.pop_back();
  if (sentence.empty()) sentence = "unknown error";
  if (sentence.back() != '.') sentence += '.';
  std::fprintf(stderr, "warplut: %s\n", sentence.c_str());
}

// Several ranks need a command that shares its work, and one program on one kind of processor: what
// kernels compute differs between instruction sets.
void RequireSharedWork(const std::string& command) {
  Ranks& ranks = Ranks::World();
  if (ranks.count() == 1) return;
  RequireUsage(std::find(std::begin(kShared), std::end(kShared), command) != std::end(kShared),
               "the command '" + command +
                   "' runs on one rank; expected train, calibrate, dataset render, judge, profile "
                   "or report, whose work ranks share");
  ranks.RequireSame("the versions of the program or the instruction sets",
                    std::string(WARPLUT_VERSION) + " " + WarpTarget());
}

// Ends all ranks after a failure of this one. The others may have failed alike: they leave the root
// the time to say so.
ExitCode EndRanks(const std::string& sentence, ExitCode code) {
  constexpr auto kPatience = std::chrono::seconds(5);
  const Ranks* ranks = Ranks::Started();
  if (ranks == nullptr || ranks->IsRoot()) {
    PrintError(sentence);
  } else {
    std::this_thread::sleep_for(kPatience);
    PrintError("rank " + std::to_string(ranks->rank()) + ": " + sentence);
  }
  if (ranks != nullptr) ranks->Abort(static_cast<int>(code));
  return code;
}

ExitCode Run(int argc, char** argv) {
  Ranks::World();  // so that the root speaks for all from here on
  CommandLine command_line(
      "warplut", "Trains, bakes, judges and runs resampling lookup tables for image warps.",
      WARPLUT_VERSION);
  CommandRun run;
  for (const CommandAdder add : kCommands) add(command_line.program(), &run);
  if (!command_line.Parse(argc, argv)) return ExitCode::kDone;
  RequireUsage(static_cast<bool>(run), "no command is given; 'warplut --help' lists them");
  RequireSharedWork(argv[1]);
  InstallInterruptHandlers();
  return run();
}

ExitCode RunGuarded(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const UsageError& wrong) {
    return EndRanks(wrong.what(), ExitCode::kUsage);
  } catch (const std::bad_alloc&) {
    return EndRanks("there is not enough memory for this input", ExitCode::kFailed);
  } catch (const std::exception& failure) {
    return EndRanks(failure.what(), ExitCode::kFailed);
  }
}

}  // namespace
}  // namespace warplut

int main(int argc, char** argv) { return static_cast<int>(warplut::RunGuarded(argc, argv)); }
