// warplut eval: a LUT against other filters, under protocols of repeated warps; or methods on
// sequences.
#include <fmt/format.h>

#include <memory>

#include "tools/commands/command.h"
#include "tools/commands/command_judge.h"
#include "tools/judge/images/image_eval.h"
#include "tools/judge/images/image_set.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/table_format.h"

namespace warplut {
namespace {

struct EvalArguments {
  EvalRequest request;
  JudgeArguments sequence;  // all that sequences take, and what images share with them
};

ExitCode RunEval(const EvalArguments& arguments) {
  if (!arguments.sequence.request.sequences.empty()) return RunJudge(arguments.sequence);
  const JudgeRequest& shared = arguments.sequence.request;
  EvalRequest request = arguments.request;
  request.targets = shared.targets;
  request.pictures = shared.pictures;
  request.pipeline = shared.pipeline;
  bool met = true;
  EvalImages(request, [&](const EvalReport& report) {
    met = report.missed.empty();
    if (arguments.sequence.json) return PrintJson(ToJson(report));
    Print(arguments.sequence.markdown ? ToMarkdown(ScoreTable(report)) : ToText(report));
    for (const std::string& sentence : report.missed) Print("missed: " + sentence + "\n");
  });
  return met ? ExitCode::kDone : ExitCode::kMissed;
}

}  // namespace

void AddEvalCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  Command command = app.AddCommand(
      "eval", "Judge a table by repeated warps (or, as judge does, methods on sequences)");
  CommandOption images = command.Add("--images", a.request.images,
                                     "Images, folders of images, or sequences (their references)");
  AddSequenceOptions(command, &a.sequence).Excludes(images);
  command.Add("--warps", a.request.warps, "Numbers of warps to judge after")
      .Separated()
      .Within(1, 1 << 20)
      .ShowDefault();
  command
      .Add("--offsets", a.request.offsets,
           "Kinds of offsets: half (by (1/2, 1/2) and back), random (back to the start), pan (one "
           "and the same)")
      .Separated()
      .OneOf({Name(Offsets::kHalf), Name(Offsets::kRandom), Name(Offsets::kPan)})
      .ShowDefault();
  command
      .Add("--against", a.request.against,
           "Filters to compare with: best-keys, best-spline (the best A or K each time), "
           "kaiser6:B, lanczos3, " +
               WarpNames())
      .Separated()
      .ShowDefault();
  command.Add("--format", a.request.format, "Storage format in which a fit or an .exr is judged")
      .OneOf(TableFormatNames())
      .ShowDefault();
  command
      .Add("--trajectories", a.request.trajectories, "Number of random trajectories for each image")
      .Within(1, 256)
      .ShowDefault();
  command
      .Add("--crop", a.request.crop,
           "Side of the window in the middle of each image; 0 judges whole images")
      .Within(0, 1 << 15)
      .ShowDefault();
  command.Add("--seed", a.request.seed, "Seed of the random trajectories").ShowDefault();
  command.Add("--target", a.sequence.request.targets,
              std::string("Targets for the SSIM, more than MARGIN above FILTER's: ") +
                  kScoreTargetForm +
                  "; on sequences the least values of a method: METHOD,PSNR,SSIM");
  command.Add("--pictures", a.sequence.request.pictures,
              "Folder for pictures: original, Catmull-Rom and the table after 24 warps; on "
              "sequences the windows where the first method errs most");
  CommandOption markdown =
      command.AddFlag("--markdown", a.sequence.markdown, "Print the table as Markdown");
  markdown.Excludes(AddJsonOption(command, &a.sequence.json));
  command.OnParsed([arguments, run] { *run = [arguments] { return RunEval(*arguments); }; });
}

}  // namespace warplut
