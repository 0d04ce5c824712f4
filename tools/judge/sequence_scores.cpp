#include "tools/judge/sequence_scores.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "datasets/error.h"
#include "tools/judge/images/image_set.h"
#include "train/metrics/luma.h"
#include "train/replay/image_views.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

Image Difference(Image a, const Image& b) {
  tbb::parallel_for(0, a.height, [&](int y) {
    const std::size_t end = a.Index(0, y + 1);
    for (std::size_t i = a.Index(0, y); i < end; ++i) a.data[i] -= b.data[i];
  });
  return a;
}

double MeanMilliseconds(const std::vector<double>& seconds) {
  if (seconds.empty()) return 0;
  const auto begin = seconds.begin() + (seconds.size() > 1 ? 1 : 0);
  return 1000 * std::accumulate(begin, seconds.end(), 0.0) /
         static_cast<double>(seconds.end() - begin);
}

std::string FrameName(int number) { return fmt::format("{:04}", number); }

// Completes what follows from the frames: their mean, and without the first `left_out`, if there
// are any, that of the others.
void AddMeans(std::size_t left_out, double settled_temporal_error, SequenceScores& scores) {
  scores.mean = MeanScore(scores.frames);
  if (left_out == 0) return;
  const auto first = scores.frames.begin() + static_cast<std::ptrdiff_t>(left_out);
  scores.settled = {.left_out = static_cast<int>(left_out),
                    .mean = MeanScore({first, scores.frames.end()}),
                    .temporal_error = settled_temporal_error};
}

}  // namespace

std::vector<double> ToNumbers(const SequenceScores& scores) {
  const SettledScores settled = scores.settled.value_or(SettledScores{});
  const JitterScores jitter = scores.jitter.value_or(JitterScores{});
  std::vector<double> numbers = {
      scores.temporal_error,  scores.milliseconds,       static_cast<double>(settled.left_out),
      settled.temporal_error, scores.jitter ? 1.0 : 0.0, jitter.repeating,
      jitter.lattice};
  for (std::size_t i = 0; i < scores.frames.size(); ++i) {
    const FrameScore& frame = scores.frames[i];
    numbers.insert(numbers.end(), {std::stod(frame.name), frame.mean_squared_error, frame.psnr,
                                   frame.ssim, scores.temporal[i]});
  }
  return numbers;
}

SequenceScores FromNumbers(const std::string& method, const std::vector<double>& numbers) {
  SequenceScores scores;
  scores.method = method;
  std::size_t at = 0;
  const auto next = [&] { return numbers.at(at++); };
  scores.temporal_error = next();
  scores.milliseconds = next();
  const auto left_out = static_cast<std::size_t>(next());
  const double settled_temporal_error = next();
  const bool has_jitter = next() != 0;
  const double repeating = next();
  const double lattice = next();
  if (has_jitter) scores.jitter = {.repeating = repeating, .lattice = lattice};
  while (at < numbers.size()) {
    FrameScore& frame = scores.frames.emplace_back();
    frame.name = FrameName(static_cast<int>(next()));
    frame.mean_squared_error = next();
    frame.psnr = next();
    frame.ssim = next();
    scores.temporal.push_back(next());
  }
  AddMeans(left_out, settled_temporal_error, scores);
  return scores;
}

std::string WhyNoJitterError(const Sequence& sequence, int first, int count) {
  std::vector<Vec2> offsets;
  for (int index = first; !sequence.jitter.empty() && index < first + count; ++index) {
    offsets.push_back(sequence.jitter[static_cast<std::size_t>(index) % sequence.jitter.size()]);
  }
  const std::optional<int> period = JitterPeriod(offsets);
  if (!period) {
    return fmt::format("the jitter of its {} frames has no whole cycle", count);
  }
  // Frame 0 is not judged, and a cut begins anew.
  int longest = 0, begin = first;
  for (int index = first + 1; index <= first + count; ++index) {
    const bool ends =
        index == first + count ||
        std::binary_search(sequence.cuts.begin(), sequence.cuts.end(), sequence.Number(index));
    if (!ends) continue;
    longest = std::max(longest, index - begin - 1);
    begin = index;
  }
  const int least = JitterErrorSum::LeastFrames(*period);
  if (longest >= least) return "";
  return fmt::format(
      "a cycle of its jitter has {} frames, {} of them in a row are needed and {} "
      "follow a first one",
      *period, least, longest);
}

FrameGeometry ReferenceGeometry(const ClipFrame& frame) {
  return {.depth = frame.reference_depth.view(), .motion = frame.reference_motion.view()};
}

Image JudgedImage(const ImageView& image, ColorEncoding encoding) {
  return DisplayedImage(ToImage(image), encoding);
}

std::vector<std::string> JudgingNotes(const Sequence& sequence,
                                      const std::vector<const MethodInfo*>& methods) {
  const Streams available = AvailableStreams(sequence);
  std::string by_rendered, without_geometry;
  for (const MethodInfo* method : methods) {
    const Streams streams = JudgingStreams(*method, available);
    const auto add = [&](std::string& names) {
      names += (names.empty() ? "" : ", ") + std::string(method->name);
    };
    if (Contains(streams, Streams::kRenderGrid)) {
      add(by_rendered);
    } else if (!Contains(streams, Streams::kOutputGrid)) {
      add(without_geometry);
    }
  }
  std::vector<std::string> notes;
  if (!without_geometry.empty()) {
    const Streams geometry = Streams::kReferenceDepth | Streams::kReferenceMotion;
    std::vector<std::string> missing;
    for (const std::string& name : StreamNames(geometry)) {
      const auto has = StreamNames(available & geometry);
      if (std::find(has.begin(), has.end(), name) == has.end()) missing.push_back(name);
    }
    notes.push_back(fmt::format("'{}' has no {}: no temporal error is computed for {}.",
                                sequence.name, fmt::join(missing, " and "), without_geometry));
  }
  if (!by_rendered.empty()) {
    notes.push_back(fmt::format(
        "'{}' has no references with depth and motion: {} are made from rendered frames and judged "
        "on the render grid by those that they did not see.",
        sequence.name, by_rendered));
  }
  for (const MethodInfo* method : methods) {
    if (method->cameras == CameraSchedule::kNone) continue;
    if (sequence.camera.empty()) {
      notes.push_back(
          fmt::format("'{}' has no cameras: {} moves by motion, as mesh-e, and draws nothing anew.",
                      sequence.name, method->name));
      continue;
    }
    notes.push_back(fmt::format(
        "{} shows {}; what moves beside the camera has the pixels of the true frame.", method->name,
        method->cameras == CameraSchedule::kOfFrame
            ? "each frame by the camera of its own time and adds no latency"
            : "generated frames by cameras between the rendered ones: that halfway is half the "
              "time between these old"));
  }
  if (sequence.color_space == ColorSpace::kLinear) {
    notes.push_back(fmt::format(
        "The linear HDR of '{}' is judged as displayed, tone-mapped (compare --linear likewise).",
        sequence.name));
  }
  return notes;
}

SequenceJudge::SequenceJudge(const Clip& truth, const MethodInfo& method, int border, int settled,
                             bool jitter)
    : truth_(truth),
      method_(method),
      border_(border),
      settled_(static_cast<std::size_t>(settled)),
      has_jitter_scores_(jitter) {
  scores_.method = method.name;
  if (!jitter || !method.super_resolution) return;
  std::vector<Vec2> offsets;
  for (const ClipFrame& frame : truth.frames) offsets.push_back(frame.jitter);
  if (const std::optional<int> period = JitterPeriod(offsets)) repeating_.emplace(*period, border);
}

void SequenceJudge::AddJitterError(const Image& error, int frame, bool judged) {
  if (!has_jitter_scores_ || !method_.super_resolution) return;
  const Image luma = Luma(error);
  if (repeating_) {
    const bool follows =
        previous_ == frame - 1 && !truth_.frames[static_cast<std::size_t>(frame)].cut;
    if (!follows) repeating_->Restart();
    repeating_->Add(luma);
  }
  if (!judged || scores_.frames.size() <= settled_) return;
  const GridSize render = truth_.render_sizes.empty()
                              ? truth_.render
                              : truth_.render_sizes[static_cast<std::size_t>(frame)];
  lattice_ += LatticeEnergy(luma, static_cast<double>(luma.width) / render.width,
                            static_cast<double>(luma.height) / render.height, border_);
}

void SequenceJudge::Add(const ShownFrame& shown) {
  if (shown.seconds > 0) seconds_.push_back(shown.seconds);
  if (shown.frame < 0 || (method_.super_resolution && shown.frame == 0)) return;
  const ClipFrame& truth = truth_.frames[static_cast<std::size_t>(shown.frame)];
  const TrueFrame known = TrueFrameOf(truth, shown.image.width, shown.image.height);
  if (known.image.width == 0) {
    throw Error(fmt::format(
        "the method {} shows {} x {} and the reference of '{}' is {} x {}; they cannot be compared",
        method_.name, shown.image.width, shown.image.height, truth_.name,
        truth.reference.view().width, truth.reference.view().height));
  }
  const Image image = JudgedImage(shown.image, truth_.encoding);
  const Image reference = JudgedImage(known.image, truth_.encoding);
  const bool judged = IsJudged(method_, shown);
  const bool settled = scores_.frames.size() >= settled_;
  if (judged) {
    scores_.frames.push_back(CompareImages(FrameName(truth.number), image, reference, border_));
  }
  Image error = Difference(image, reference);
  TemporalErrorSum sum;
  if (known.HasGeometry() && !previous_error_.empty() && previous_ == shown.frame - 1 &&
      !truth.cut) {
    const TrueFrame before = TrueFrameOf(truth_.frames[static_cast<std::size_t>(previous_)],
                                         shown.image.width, shown.image.height);
    sum = TemporalError(error, {known.depth, known.motion}, previous_error_,
                        {before.depth, before.motion}, border_);
    temporal_ += sum;
    if (settled) settled_temporal_ += sum;
  }
  if (judged) scores_.temporal.push_back(sum.Rms());
  AddJitterError(error, shown.frame, judged);
  previous_ = shown.frame;
  previous_error_ = std::move(error);
}

SequenceScores SequenceJudge::Finish() const {
  if (scores_.frames.empty()) {
    throw Error(fmt::format(
        "the method {} showed no frame of '{}' that it is judged by and that has a reference",
        method_.name, truth_.name));
  }
  if (settled_ >= scores_.frames.size()) {
    throw Error(fmt::format(
        "the settled mean leaves out {} frames and the method {} is judged by {} of '{}'; expected "
        "at least one more",
        settled_, method_.name, scores_.frames.size(), truth_.name));
  }
  SequenceScores scores = scores_;
  scores.temporal_error = temporal_.Rms();
  AddMeans(settled_, settled_temporal_.Rms(), scores);
  scores.milliseconds = MeanMilliseconds(seconds_);
  if (has_jitter_scores_) {
    scores.jitter = {.repeating = (repeating_ ? repeating_->Energy() : ErrorEnergy{}).Rms(),
                     .lattice = lattice_.Rms()};
  }
  return scores;
}

}  // namespace warplut
