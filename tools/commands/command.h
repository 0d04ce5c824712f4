// What the subcommands of `warplut` share: how they are registered, how they end, how they print.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "tools/commands/command_line.h"
#include "tools/tables/record_table.h"
#include "tools/usage_error.h"

namespace warplut {

// The exit code of the program.
enum class ExitCode : std::uint8_t {
  kDone = 0,
  kUsage = 1,   // the command line is wrong
  kFailed = 2,  // an input, the machine or an interruption stopped it
  kMissed = 3,  // done, but a stated target was missed, or a manifest is contradicted
};

// What the codes mean, in their order.
inline constexpr const char* kExitMeanings[] = {
    "Done.", "The command line is wrong.", "An input, the machine or an interruption stopped it.",
    "Done, but a stated target was missed, or a manifest is contradicted."};

using CommandRun = std::function<ExitCode()>;

// Adds one subcommand to `app`. Parsing it sets `*run`, which must outlive `app`, to what it does.
using CommandAdder = void (*)(Command app, CommandRun* run);

void AddDatasetCommand(Command app, CommandRun* run);
void AddTrainCommand(Command app, CommandRun* run);
void AddBakeCommand(Command app, CommandRun* run);
void AddEvalCommand(Command app, CommandRun* run);
void AddJudgeCommand(Command app, CommandRun* run);
void AddCalibrateCommand(Command app, CommandRun* run);
void AddCrossCommand(Command app, CommandRun* run);
void AddProfileCommand(Command app, CommandRun* run);
void AddReportCommand(Command app, CommandRun* run);
void AddRunCommand(Command app, CommandRun* run);
void AddStabilityCommand(Command app, CommandRun* run);
void AddDenseCommand(Command app, CommandRun* run);
void AddReflectionsCommand(Command app, CommandRun* run);
void AddCompareCommand(Command app, CommandRun* run);
void AddBenchCommand(Command app, CommandRun* run);
void AddViewCommand(Command app, CommandRun* run);
void AddCompletionCommand(Command app, CommandRun* run);
void AddManCommand(Command app, CommandRun* run);

// The subcommands in the order of the data flow.
inline constexpr CommandAdder kCommands[] = {
    AddDatasetCommand,    AddTrainCommand,       AddBakeCommand,      AddEvalCommand,
    AddCrossCommand,      AddJudgeCommand,       AddCalibrateCommand, AddProfileCommand,
    AddRunCommand,        AddCompareCommand,     AddViewCommand,      AddBenchCommand,
    AddDenseCommand,      AddReflectionsCommand, AddReportCommand,    AddStabilityCommand,
    AddCompletionCommand, AddManCommand};

// Adds and returns the option `--json` that every command has.
CommandOption AddJsonOption(Command command, bool* json);

// Writes to standard output, from the root of the ranks; an Error if that fails (a full disk, for
// example).
void Print(std::string_view text);

// Writes a JSON document and a newline to standard output.
void PrintJson(const Json& document);

}  // namespace warplut
