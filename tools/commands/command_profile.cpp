// warplut profile: what content can do without, and the pipeline that is left as a header.
#include <algorithm>
#include <memory>

#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/profile/profile_job.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

struct ProfileArguments {
  ProfileRequest request;
  bool generated_given = false;
  bool json = false;
  bool markdown = false;
};

ExitCode RunProfileCommand(const ProfileArguments& arguments) {
  ProfileRequest request = arguments.request;
  if (!arguments.generated_given) request.pipeline.generated = std::max(1, request.every - 1);
  const ProfileReport report = RunProfile(request, WARPLUT_VERSION);
  if (!Ranks::World().IsRoot()) return ExitCode::kDone;
  if (arguments.json) {
    Json json = {{"pipeline", request.out}};
    json.update(ToJson(report));
    PrintJson(json);
  } else {
    Print(arguments.markdown ? ToMarkdown(report) : ToText(report));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddProfileCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ProfileArguments>();
  ProfileRequest& a = arguments->request;
  Command command =
      app.AddCommand("profile", "Find the passes that content can do without and write PIPELINE.h");
  command.Add("--sequence", a.sequences, "Sequences to profile, best with references").Required();
  command.Add("--mode", a.mode, "Method to profile: sr, i, e, isr or esr").ShowDefault();
  command.Add("--out", a.out, "Header to write").Required();
  command
      .Add("--within", a.within,
           "Largest loss of SSIM against the full pipeline, on the worst sequence")
      .ShowDefault();
  command.Add("--every", a.every, "Render every N-th frame, in modes that generate")
      .Within(2, 64)
      .ShowDefault();
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  CommandOption markdown =
      command.AddFlag("--markdown", arguments->markdown, "Print the tables as Markdown");
  markdown.Excludes(AddJsonOption(command, &arguments->json));
  command.OnParsed([arguments, run, command] {
    arguments->generated_given = command.Given("--generated") || command.Given("--alpha");
    *run = [arguments] { return RunProfileCommand(*arguments); };
  });
}

}  // namespace warplut
