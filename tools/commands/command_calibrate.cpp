// warplut calibrate: the parameters that fit a person's clips.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "tools/calibration/calibration_job.h"
#include "tools/commands/command.h"
#include "tools/commands/pipeline_options.h"

namespace warplut {
namespace {

struct CalibrateArguments {
  CalibrationRequest request;
  bool generated_given = false;
  bool json = false;
};

ExitCode RunCalibrate(const CalibrateArguments& arguments) {
  CalibrationRequest request = arguments.request;
  if (!arguments.generated_given) request.pipeline.generated = std::max(1, request.every - 1);
  const CalibrationReport report = RunCalibration(request);
  if (arguments.json) {
    PrintJson({{"parameters", request.out}, {"calibration", ToJson(report)}});
  } else {
    Print(fmt::format("{}: {} runs of the pipeline in {:.1f} s\n\n{}", request.out,
                      report.result.runs, report.result.seconds, ToText(report)));
  }
  return ExitCode::kDone;
}

}  // namespace

void AddCalibrateCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CalibrationRequest& a = arguments->request;
  Command command = app.AddCommand(
      "calibrate", "Fit the parameters of the pipeline to clips and write PARAMS.json");
  command.Add("--sequence", a.sequences, "Sequences to fit, with references").Required();
  command.Add("--modes", a.modes, "Methods to fit the parameters to, with equal weight")
      .Separated()
      .ShowDefault();
  command
      .Add("--out", a.out,
           "Parameters to write; PARAMS.json.checkpoint stands next to them meanwhile")
      .Required();
  CommandOption hold_out =
      command.Add("--hold-out", a.hold_out, "Names of sequences to judge by, not to fit")
          .Separated();
  command
      .AddFlag("--split-frames", a.split_frames,
               "Fit the first half of each clip and judge by the second")
      .Excludes(hold_out);
  command.Add("--fit", a.fit, "Names of parameters to fit (default: all that the modes read)")
      .Separated();
  command
      .Add("--keep", a.keep,
           "Point to keep: near (as near to the defaults as the clips allow) or optimum (the "
           "optimum of these clips)")
      .OneOf({"near", "optimum"})
      .ShowDefault();
  command
      .Add("--starts", a.starts,
           "Number of random starts, besides the defaults and the paper's constants")
      .Within(0, 1000)
      .ShowDefault();
  command.Add("--seed", a.seed, "Seed of the random starts").ShowDefault();
  command.Add("--max-seconds", a.max_seconds, "Time limit of the search in seconds (default: none)")
      .NotNegative();
  command.Add("--every", a.every, "Render every N-th frame, in modes that generate")
      .Within(2, 64)
      .ShowDefault();
  command
      .Add("--max-pixels", a.max_pixels,
           "Number of output pixels to fit, in the middle of each frame (default: all; 500000 "
           "are quick)")
      .Within(1, std::numeric_limits<int>::max());
  command
      .Add("--max-frames", a.max_frames,
           "Number of frames to fit, from the first of each clip (default: all)")
      .Within(1, std::numeric_limits<int>::max());
  command.Add("--memory", a.memory,
              "Most memory for clips, as 2G or 500M, on each rank; clips that find no room are "
              "loaded for every run of the pipeline (default: all are kept)");
  command.AddFlag("--resume", a.resume, "Continue an interrupted calibration from its checkpoint");
  AddTableOptions(command, &a.pipeline);
  AddPipelineOptions(command, &a.pipeline);
  AddJsonOption(command, &arguments->json);
  command.OnParsed([arguments, run, command] {
    arguments->generated_given = command.Given("--generated") || command.Given("--alpha");
    *run = [arguments] { return RunCalibrate(*arguments); };
  });
}

}  // namespace warplut
