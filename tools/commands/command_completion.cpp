// warplut completion: a script that completes the command line in a shell.
#include <memory>

#include "tools/commands/command.h"
#include "tools/manual/completion_script.h"

namespace warplut {

void AddCompletionCommand(Command app, CommandRun* run) {
  struct Arguments {
    std::string shell;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  Command command =
      app.AddCommand("completion", "Print a script that completes the command line in a shell");
  command.Add("shell", arguments->shell, "Shell that is to complete")
      .Required()
      .OneOf(CompletionShells());
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, app, run] {
    *run = [arguments, app] {
      const std::string script = CompletionScript(arguments->shell, app.Describe());
      if (arguments->json) {
        PrintJson({{"shell", arguments->shell}, {"script", script}});
      } else {
        Print(script);
      }
      return ExitCode::kDone;
    };
  });
}

}  // namespace warplut
