#include "tools/run/mode_runner.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/file.h"
#include "tools/pictures/hud_layer.h"
#include "tools/run/alpha_run.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "tools/usage_error.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

ShownFormat FormatOf(const RunRequest& request, const Sequence& sequence) {
  const bool linear = sequence.color_space == ColorSpace::kLinear;
  if (request.format.empty()) return linear ? ShownFormat::kExr : ShownFormat::kPng;
  RequireUsage(!linear || request.format == "exr",
               fmt::format("'{}' has linear colour, which .png cannot hold; expected --format exr",
                           sequence.name));
  return request.format == "exr" ? ShownFormat::kExr : ShownFormat::kPng;
}

double ShownFrames(const ModeRunOptions& options, int count) {
  const int rendered = (count - 1) / options.every + 1;
  if (options.method->generation == Generation::kNone) return rendered;
  return rendered + (rendered - 1.0) * static_cast<double>(Alphas(options).size());
}

}  // namespace

ModeRunner::ModeRunner(const RunRequest& request)
    : request_(request),
      methods_(AsUsage([&] {
        std::vector<const MethodInfo*> methods = MethodsOf(request.modes, "--mode");
        CheckDevice(request.device);
        CheckArguments(request.pipeline);
        return methods;
      })),
      pipeline_(request.pipeline),
      sequence_(ReadSequenceFor(pipeline_, request.sequence, methods_)),
      format_(FormatOf(request, sequence_)),
      range_(ParseFrames(request.pipeline.frames, sequence_)),
      device_(OpenDevice(request.device)),
      pool_(request.pipeline.threads) {}

std::vector<ModeOutput> ModeRunner::Run() {
  RequireWritableFolder(request_.out);
  for (const MethodInfo* method : methods_) CheckMode(*method);
  std::vector<ModeOutput> outputs;
  for (const MethodInfo* method : methods_) outputs.push_back(RunOne(*method));
  return outputs;
}

ModeRunOptions ModeRunner::OptionsOf(const MethodInfo& method) const {
  ModeRunOptions options = pipeline_.Options(method, request_.every);
  options.device = device_.get();
  // Colour is divided by alpha where it is written: 8 bits would be too few.
  if (AlphaStreamOf(sequence_, method) != Streams::kNone) {
    options.shown_format = PixelFormat::kRgba16F;
  }
  return options;
}

Clip ModeRunner::Load(const FrameRange& range, const MethodInfo& method) const {
  const ModeRunOptions options = OptionsOf(method);
  Clip clip =
      pipeline_.Load(sequence_, range, {&method}, AlphaStreamOf(sequence_, method), options.every);
  std::string why;
  if (!options.IsValid(clip, &why)) throw Error(why);
  return clip;
}

// Runs before the first mode: an Error tells what a later one lacks, a stream or a choice.
void ModeRunner::CheckMode(const MethodInfo& method) const {
  LoadFrame(sequence_, range_.first, NeededStreams(method, AvailableStreams(sequence_)));
  if (request_.score) TruthStreams(method);
  if (device_ == nullptr) return;
  // One frame that is rendered after the first.
  Load({range_.first, std::min(range_.count, request_.every + 1)}, method);
}

// Frames with alpha are premultiplied by it, and so is what they are judged by.
Clip ModeRunner::LoadTruth(const MethodInfo& method) const {
  return LoadClip(sequence_, range_.first, range_.count, TruthStreams(method));
}

Streams ModeRunner::TruthStreams(const MethodInfo& method) const {
  const Streams available = AvailableStreams(sequence_);
  const Streams streams = JudgingStreams(method, available);
  if (AlphaStreamOf(sequence_, method) == Streams::kNone ||
      !Contains(streams, Streams::kReference)) {
    return streams;
  }
  RequireUsage(Contains(available, Streams::kReferenceAlpha),
               fmt::format("'{}' has an alpha, and its reference has none; expected the stream "
                           "reference_alpha to judge by, or no --score",
                           sequence_.name));
  return streams | Streams::kReferenceAlpha;
}

ModeOutput ModeRunner::RunOne(const MethodInfo& method) {
  const ModeRunOptions options = OptionsOf(method);
  Clip clip = Load(range_, method);
  std::optional<Clip> truth;
  std::optional<SequenceJudge> judge;
  if (request_.score) {
    truth = LoadTruth(method);
    judge.emplace(*truth, method, kScoreBorder, request_.settled);
  }
  WarnOfLimitedColor({&clip, truth ? &*truth : nullptr});
  ModeOutput output;
  output.mode = method.name;
  output.folder = request_.out;
  if (methods_.size() > 1) output.folder /= output.mode;
  CreateFolder(output.folder);
  const int first = clip.frames.front().number;
  HudLayer hud(sequence_, range_.first, pool_);
  const Streams alpha_stream = AlphaStreamOf(sequence_, method);
  const bool has_alpha = alpha_stream != Streams::kNone;
  Progress progress(
      "running " + output.mode,
      ShownFrames(options, static_cast<int>(clip.frames.size())) * (has_alpha ? 2 : 1), "frames");
  std::vector<ShownAlpha> alphas;
  if (has_alpha) {
    alphas = RunAlpha(clip, alpha_stream, options, pool_, [&] {
      ThrowIfInterrupted("run", "no frame is written yet");
      progress.Add(1);
    });
  }
  RunMode(clip, options, pool_, [&](const ShownFrame& shown) {
    ThrowIfInterrupted("run", "the frames that are written are whole");
    Image alpha;
    if (has_alpha) {
      alpha = ToImage(alphas.at(output.files.size()), shown.image.width, shown.image.height);
    }
    WriteShownFrame(output.folder, first, hud.Over(shown), clip.encoding, format_,
                    has_alpha ? &alpha : nullptr);
    output.files.push_back(ShownFileName(first, shown.time, format_));
    if (judge) judge->Add(shown);
    progress.Add(1);
  });
  if (judge) {
    output.scores = SequenceReport{.sequence = sequence_.name,
                                   .methods = {judge->Finish()},
                                   .notes = JudgingNotes(sequence_, {&method})};
  }
  return output;
}

}  // namespace warplut
