#include "tools/pipeline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "datasets/error.h"
#include "datasets/jitter.h"
#include "luts/certificate/certificate.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/terminal/warning.h"
#include "train/replay/clip_texels.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

// Scales that round to the same hundredth are one.
constexpr double kSameScale = 0.005;

double ScaleOf(const Sequence& sequence) {
  return std::sqrt(static_cast<double>(sequence.output.width) / sequence.render.width *
                   sequence.output.height / sequence.render.height);
}

std::optional<int> ParseNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

MotionFiltering FilteringOf(const PipelineArguments& arguments) {
  if (arguments.motion_filter == "on") return MotionFiltering::kOn;
  return arguments.motion_filter == "auto" ? MotionFiltering::kQuantised : MotionFiltering::kOff;
}

}  // namespace

FrameRange ParseFrames(const std::string& text, const Sequence& sequence) {
  if (text.empty()) return {.first = 0, .count = sequence.count};
  const auto colon = text.find(':');
  const auto a = ParseNumber(std::string_view(text).substr(0, colon));
  const auto b = colon == std::string::npos ? std::nullopt
                                            : ParseNumber(std::string_view(text).substr(colon + 1));
  if (!a || !b || *a > *b) {
    throw Error(fmt::format(
        "the frames are '{}'; expected A:B, the numbers of the first and the last", text));
  }
  const int last = sequence.LastNumber();
  if (*a < sequence.first || *b > last) {
    throw Error(
        fmt::format("the sequence '{}' has frames {} to {}; the frames {} are not all there",
                    sequence.name, sequence.first, last, text));
  }
  if (sequence.numbers.empty()) return {.first = *a - sequence.first, .count = *b - *a + 1};
  const auto& numbers = sequence.numbers;
  const auto begin = std::lower_bound(numbers.begin(), numbers.end(), *a);
  const auto end = std::upper_bound(numbers.begin(), numbers.end(), *b);
  if (begin == end) {
    throw Error(
        fmt::format("the sequence '{}' has no frames from {} to {}", sequence.name, *a, *b));
  }
  return {.first = static_cast<int>(begin - numbers.begin()),
          .count = static_cast<int>(end - begin)};
}

std::vector<std::string> HistoryFormatNames() {
  std::vector<std::string> names;
  for (const PixelFormat format : kColorFormats) names.emplace_back(Name(format));
  return names;
}

const MethodInfo& MethodOf(const std::string& name) {
  const MethodInfo* method = FindMethod(name);
  if (method != nullptr) return *method;
  std::vector<std::string> known;
  for (const MethodInfo& info : Methods()) known.emplace_back(info.name);
  throw Error(fmt::format("'{}' is not a method; expected {}", name, fmt::join(known, ", ")));
}

std::vector<const MethodInfo*> MethodsOf(const std::vector<std::string>& names,
                                         const std::string& option) {
  std::vector<const MethodInfo*> methods;
  for (const std::string& name : names) {
    const MethodInfo& method = MethodOf(name);
    if (std::find(methods.begin(), methods.end(), &method) != methods.end()) {
      throw Error(fmt::format("{} has {} twice; expected it once", option, name));
    }
    methods.push_back(&method);
  }
  return methods;
}

void CheckArguments(const PipelineArguments& arguments) {
  if (arguments.lut.empty() == arguments.filter.empty()) {
    throw Error("the filter of the history is not clear; expected --lut FILE or --filter NAME");
  }
  if (!arguments.filter.empty() && !NamedWarp(arguments.filter)) {
    throw Error(fmt::format("'{}' is not a filter; expected {}", arguments.filter, WarpNames()));
  }
  if (!(arguments.coherent_share >= 0 && arguments.coherent_share <= 1)) {
    throw Error(fmt::format("the share of coherent residuals is {}; expected 0 to 1",
                            arguments.coherent_share));
  }
  // What holds for every clip; RunMode's own check is for the clip in hand.
  ModeRunOptions options;
  options.generated = arguments.generated;
  options.alphas = arguments.alphas;
  std::string why;
  if (!AreTimesValid(options, &why)) throw Error(why);
}

Lookup LookupOf(const PipelineArguments& arguments) {
  return arguments.lookup == Name(Lookup::kNearest) ? Lookup::kNearest : Lookup::kBilinear;
}

Pipeline::Pipeline(const PipelineArguments& arguments) : arguments_(arguments) {
  CheckArguments(arguments);
  if (arguments.lut.empty()) {
    filter_name_ = arguments.filter;
    warp_ = *NamedWarp(arguments.filter);
  } else {
    loaded_ = LoadTable(arguments.lut);
    filter_name_ = loaded_->name;
    table_.emplace(loaded_->table.view());
    warp_ = {.filter = Filter::kLut, .table = &*table_, .lookup = LookupOf(arguments)};
  }
  if (!arguments.params.empty()) parameters_ = ReadParameters(arguments.params);
}

ModeRunOptions Pipeline::Options(const MethodInfo& method, int every) const {
  ModeRunOptions options;
  options.method = &method;
  options.every = every;
  options.generated = arguments_.generated;
  options.alphas = arguments_.alphas;
  options.super_resolution.warp = warp_;
  options.super_resolution.parameters = parameters_;
  const MotionFiltering filtering = FilteringOf(arguments_);
  options.super_resolution.motion_filter = filtering == MotionFiltering::kOn;
  options.super_resolution.coherent_share = arguments_.coherent_share;
  for (const PixelFormat format : kColorFormats) {
    if (arguments_.history == Name(format)) options.super_resolution.history_format = format;
  }
  options.generation.warp = warp_;
  options.generation.parameters = parameters_;
  options.generation.motion_filter = options.super_resolution.motion_filter;
  options.filter_quantised_motion = filtering == MotionFiltering::kQuantised;
  return options;
}

std::optional<std::string> Pipeline::ScaleWarning(const Sequence& sequence) const {
  if (!loaded_ || !loaded_->scale) return std::nullopt;
  const double fitted = *loaded_->scale, wanted = ScaleOf(sequence);
  if (std::abs(fitted - wanted) < kSameScale) return std::nullopt;
  const auto safe = CertifyStability(loaded_->table.view()).any.safe_warps;
  return fmt::format(
      "the LUT '{}' was fitted for x{:.3g} and '{}' has x{:.3g}: history is warped about {} times "
      "in a jitter cycle instead of {}, and {} warps are safe",
      loaded_->name, fitted, sequence.name, wanted, JitterCycle(wanted).size(),
      JitterCycle(fitted).size(), safe ? fmt::format("{}", *safe) : "any number of");
}

Clip Pipeline::Load(const Sequence& sequence, const FrameRange& range,
                    const std::vector<const MethodInfo*>& methods, Streams more, int every,
                    bool raw_motion) const {
  Streams which = more;
  for (const MethodInfo* method : methods) {
    which = which | NeededStreams(*method, AvailableStreams(sequence));
  }
  if (arguments_.texels) which = Streams::kOutputGrid;
  const MotionFiltering filtering =
      methods.empty() ? MotionFiltering::kOff : FilteringOf(arguments_);
  Clip clip = LoadClip(sequence, range.first, range.count, which, every,
                       raw_motion ? MotionFiltering::kOff : filtering);
  // The passes are told of raw motion all the same.
  if (raw_motion && filtering == MotionFiltering::kQuantised) {
    clip.quantised_motion = HasQuantisedMotion(clip);
  }
  if (arguments_.texels) TakeTexels(clip);
  return clip;
}

Sequence ReadSequenceFor(const Pipeline& pipeline, const std::string& path,
                         const std::vector<const MethodInfo*>& methods) {
  Sequence sequence = ReadSequence(path, pipeline.streams_below());
  if (std::none_of(methods.begin(), methods.end(),
                   [](const MethodInfo* method) { return HasHistory(*method); })) {
    return sequence;
  }
  if (const auto warning = pipeline.ScaleWarning(sequence)) Warn(*warning);
  return sequence;
}

}  // namespace warplut
