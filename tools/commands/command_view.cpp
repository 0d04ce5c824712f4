// warplut view: frames of two methods, or of two folders, for the eye.
#include <memory>

#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"
#include "tools/view/view_job.h"

namespace warplut {
namespace {

struct ViewArguments {
  ViewRequest request;
  bool json = false;
};

ExitCode RunViewCommand(const ViewArguments& arguments) {
  const ViewResult result = RunView(arguments.request);
  if (arguments.json) {
    PrintJson({{"files", result.files}, {"sentences", result.sentences}});
    return ExitCode::kDone;
  }
  for (const std::string& file : result.files) Print(file + "\n");
  for (const std::string& sentence : result.sentences) Print(sentence + "\n");
  return ExitCode::kDone;
}

}  // namespace

void AddViewCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<ViewArguments>();
  ViewRequest& a = arguments->request;
  Command command = app.AddCommand(
      "view", "Draw frames of two methods or folders for the eye: pictures, a page, a video");
  CommandOption folders =
      command.Add("folders", a.folders, "Two folders of images, sequences or images to compare");
  CommandOption sequence =
      command.Add("--sequence", a.sequence, "Sequence to run two methods on, instead of folders");
  sequence.Excludes(folders);
  command.Add("--modes,--methods", a.methods, "Two methods to run on the sequence")
      .Separated()
      .ShowDefault();
  command.Add("--out", a.out, "Folder for the pictures and the page").Required();
  command
      .Add("--reference", a.reference, "Folder of ideal frames, by the names of those of folders")
      .Excludes(sequence);
  command.Add("--shown", a.shown, "Number of frames on the sheet and the page, beside the worst")
      .Within(1, kMostShown)
      .ShowDefault();
  command.Add("--amplify", a.amplify, "Factor by which errors are drawn larger").ShowDefault();
  command.Add("--rate", a.rate, "Frames of the video per second").ShowDefault();
  command.AddFlag("--linear", a.linear, "Show linear HDR files of folders as displayed");
  command.Add("--every", a.every, "Render every N-th frame, for methods that generate")
      .Within(2, 64)
      .ShowDefault();
  AddDeviceOption(command, &a.device).Needs(sequence);
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run] { *run = [arguments] { return RunViewCommand(*arguments); }; });
}

}  // namespace warplut
