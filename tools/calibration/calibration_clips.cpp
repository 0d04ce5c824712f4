#include "tools/calibration/calibration_clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "tools/usage_error.h"
#include "train/calibration/clip_crop.h"
#include "train/ranks/ranks.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

// The runs of one part: super resolution on all frames, what generates on one in `every`. Its owner
// alone loads the clip, from the shelf. `part` and `pipeline` outlive the runs.
std::vector<ClipRun> RunsOf(const CalibrationRequest& request, const Pipeline& pipeline,
                            const std::vector<const MethodInfo*>& methods,
                            const CalibrationPart& part, int owner, ClipShelf& shelf) {
  std::vector<ClipRun> runs;
  Clip limited;  // what there is to warn of
  limited.name = part.sequence.name;
  for (const bool generates : {false, true}) {
    const int every = generates ? request.every : 1;
    std::vector<const MethodInfo*> same;
    Streams judging = Streams::kNone;
    for (const MethodInfo* method : methods) {
      if ((method->generation != Generation::kNone) != generates) continue;
      same.push_back(method);
      judging = judging | JudgingStreams(*method, AvailableStreams(part.sequence));
    }
    if (same.empty()) continue;
    ClipSource source;
    if (owner == Ranks::World().rank()) {
      const Streams more = judging & (Streams::kReference | Streams::kColor);
      source = shelf.Add([&pipeline, &part, same, more, every, pixels = request.max_pixels] {
        return CropClip(pipeline.Load(part.sequence, part.range, same, more, every), pixels);
      });
      const std::shared_ptr<const Clip> clip = source.Take();
      limited.limited_color = std::max(limited.limited_color, clip->limited_color);
      limited.limited_reference = std::max(limited.limited_reference, clip->limited_reference);
    }
    for (const MethodInfo* method : same) {
      runs.push_back({.clip = source,
                      .options = pipeline.Options(*method, every),
                      .name = part.sequence.name,
                      .owner = owner});
    }
  }
  WarnOfLimitedColor({&limited});
  return runs;
}

// The rank that runs each part: those that are fitted and those that are held out are shared apart.
std::vector<int> OwnersOf(const std::vector<CalibrationPart>& parts) {
  std::vector<int> owners(parts.size());
  for (const bool held_out : {false, true}) {
    std::vector<std::size_t> indices;
    std::vector<double> work;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].held_out != held_out) continue;
      const GridSize& output = parts[i].sequence.output;
      indices.push_back(i);
      work.push_back(static_cast<double>(parts[i].range.count) * output.width * output.height);
    }
    const std::vector<int> balanced = BalancedOwners(work, Ranks::World().count());
    for (std::size_t k = 0; k < indices.size(); ++k) owners[indices[k]] = balanced[k];
  }
  return owners;
}

}  // namespace

std::vector<CalibrationPart> CalibrationParts(const CalibrationRequest& request,
                                              const Pipeline& pipeline,
                                              const std::vector<const MethodInfo*>& methods) {
  std::vector<CalibrationPart> parts;
  std::set<std::string> names;
  for (const std::string& path : request.sequences) {
    CalibrationPart part{.sequence = ReadSequenceFor(pipeline, path, methods), .range = {}};
    const std::string& name = part.sequence.name;
    if (!names.insert(name).second) {
      throw Error(fmt::format("two sequences have the name '{}'; expected different ones", name));
    }
    part.range = ParseFrames(request.pipeline.frames, part.sequence);
    if (request.max_frames > 0) {
      part.range.count = std::min(part.range.count, request.max_frames);
    }
    part.held_out =
        std::find(request.hold_out.begin(), request.hold_out.end(), name) != request.hold_out.end();
    if (request.split_frames) {
      const FrameRange whole = part.range;
      part.range.count = whole.count / 2;
      CalibrationPart rest = part;
      rest.range = {whole.first + whole.count / 2, whole.count - whole.count / 2};
      rest.held_out = true;
      if (part.range.count > 0) parts.push_back(part);
      parts.push_back(std::move(rest));
    } else {
      parts.push_back(std::move(part));
    }
  }
  for (const std::string& name : request.hold_out) {
    RequireUsage(names.contains(name),
                 fmt::format("--hold-out names '{}', which no sequence has as its name", name));
  }
  RequireUsage(std::any_of(parts.begin(), parts.end(),
                           [](const CalibrationPart& part) { return !part.held_out; }),
               "every clip is held out; expected one at least to calibrate on");
  return parts;
}

CalibrationRuns LoadCalibrationRuns(const CalibrationRequest& request, const Pipeline& pipeline,
                                    const std::vector<const MethodInfo*>& methods,
                                    const std::vector<CalibrationPart>& parts, ClipShelf& shelf) {
  CalibrationRuns split;
  const std::vector<int> owners = OwnersOf(parts);
  Progress progress("loading", static_cast<double>(parts.size()), "clips");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    ThrowIfInterrupted("calibrate", "nothing was written");
    const CalibrationPart& part = parts[i];
    std::vector<ClipRun> runs = RunsOf(request, pipeline, methods, part, owners[i], shelf);
    auto& to = part.held_out ? split.held_out : split.fitted;
    to.insert(to.end(), runs.begin(), runs.end());
    progress.Add(1);
  }
  return split;
}

std::string CalibrationData(const CalibrationRequest& request, const Pipeline& pipeline,
                            const std::vector<CalibrationPart>& parts) {
  std::string text =
      fmt::format("{} {} {}", pipeline.filter_name(), request.every, request.max_pixels);
  for (const std::string& mode : request.modes) text += " " + mode;
  for (const CalibrationPart& part : parts) {
    if (part.held_out) continue;
    text +=
        fmt::format(" {} {} {}", SequenceJson(part.sequence), part.range.first, part.range.count);
  }
  return text;
}

}  // namespace warplut
