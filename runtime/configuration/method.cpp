#include "runtime/method.h"

#include <array>
#include <cstddef>

#include "runtime/configuration/choice_list.h"
#include "runtime/configuration/parameter_index.h"

namespace warplut {
namespace {

// The index in kParameters; a name that is not there does not compile.
// ParameterIndex of a parameter that there is.
consteval int IndexOf(std::string_view name) {
  const int index = ParameterIndex(name);
  if (index < 0) throw "no such parameter";
  return index;
}

constexpr int kSrDepth = IndexOf("sr_depth_threshold");
constexpr int kGenerationDepth = IndexOf("generation_depth_threshold");
constexpr int kBrightness = IndexOf("brightness_threshold");
constexpr int kBlendA = IndexOf("blend_a");
constexpr int kBlendB = IndexOf("blend_b");
constexpr int kGamma = IndexOf("clamp_gamma");

// Takes what a method decides from the defaults; the rest belongs to the caller.
template <class List, class Options>
constexpr void TakeDefaults(const List& list, Options& options) {
  const Options defaults;
  ForEachChoice(list, [&](const auto& choice) {
    if (choice.owner != ChoiceOwner::kMethod) return;
    options.*choice.option = defaults.*choice.option;
  });
}

constexpr void ConfigureSr(SuperResolutionOptions& options) { TakeDefaults(kSrChoices, options); }

constexpr void ConfigureSrSample(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.form = HistoryForm::kSample;
}

constexpr void ConfigureSrResidual(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.form = HistoryForm::kResidual;
}

constexpr void ConfigureSrPaper(SuperResolutionOptions& options) {
  options.form = HistoryForm::kSample;
  options.history = true;
  options.clamp = ColorClamp::kBox;
  options.depth = DepthMeasure::kAbsolute;
  options.motion = MotionUpsampling::kDilated;
  options.motion_filter = false;
  options.current = CurrentFrame::kBilinear;
}

constexpr void ConfigureBicubic(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.history = false;
  options.motion_filter = false;
  options.current = CurrentFrame::kBicubic;
}

constexpr void ConfigureBilinear(SuperResolutionOptions& options) {
  ConfigureBicubic(options);
  options.current = CurrentFrame::kBilinear;
}

constexpr void ConfigureGeneration(FrameGenerationOptions& options) {
  TakeDefaults(kGenerationChoices, options);
}

constexpr void ConfigureGenerationPaper(FrameGenerationOptions& options) {
  options.motion_model = MotionModel::kQuadratic;
  options.splat = true;
  options.refine = true;
  options.fill = DisocclusionFill::kOwnMotion;
  options.depth = DepthMeasure::kAbsolute;
  options.brightness_gate = true;
  options.motion_filter = false;
}

using SrConfigure = void (*)(SuperResolutionOptions&);
using GenerationConfigure = void (*)(FrameGenerationOptions&);

struct ParameterList {
  std::array<int, kParameters.size()> indices{};
  std::size_t size = 0;

  constexpr void Add(int index) { indices[size++] = index; }
};

// What the passes of configured options read; either function may be null.
constexpr ParameterList Reads(SrConfigure configure_sr, GenerationConfigure configure_generation,
                              Generation generation) {
  ParameterList list;
  if (configure_sr != nullptr) {
    SuperResolutionOptions options;
    configure_sr(options);
    if (options.history) {
      if (options.depth != DepthMeasure::kNone) list.Add(kSrDepth);
      list.Add(kBlendA);
      list.Add(kBlendB);
      if (options.clamp == ColorClamp::kVariance) list.Add(kGamma);
    }
  }
  if (configure_generation != nullptr) {
    FrameGenerationOptions options;
    configure_generation(options);
    if (options.depth != DepthMeasure::kNone) list.Add(kGenerationDepth);
    if (generation == Generation::kInterpolation && options.brightness_gate) list.Add(kBrightness);
  }
  return list;
}

template <SrConfigure kSr, GenerationConfigure kFrames, Generation kGeneration>
constexpr ParameterList kReads = Reads(kSr, kFrames, kGeneration);

template <SrConfigure kSr, GenerationConfigure kFrames, Generation kGeneration>
constexpr MethodInfo Method(const char* name, const char* meaning, bool paper = false,
                            Generator generator = Generator::kWarped) {
  constexpr const ParameterList& kList = kReads<kSr, kFrames, kGeneration>;
  return {.name = name,
          .meaning = meaning,
          .super_resolution = kSr != nullptr,
          .generation = kGeneration,
          .generator = generator,
          .paper = paper,
          .configure_super_resolution = kSr,
          .configure_generation = kFrames,
          .parameters = std::span<const int>(kList.indices.data(), kList.size)};
}

constexpr auto kNone = Generation::kNone;
constexpr auto kInterpolation = Generation::kInterpolation;
constexpr auto kExtrapolation = Generation::kExtrapolation;

constexpr MethodInfo kMethods[] = {
    Method<ConfigureSr, nullptr, kNone>("sr", "super resolution"),
    Method<nullptr, ConfigureGeneration, kInterpolation>("i", "interpolation"),
    Method<nullptr, ConfigureGeneration, kExtrapolation>("e", "extrapolation"),
    Method<ConfigureSr, ConfigureGeneration, kInterpolation>("isr", "sr, then i"),
    Method<ConfigureSr, ConfigureGeneration, kExtrapolation>("esr", "sr, then e"),
    Method<ConfigureSrSample, nullptr, kNone>("sr-sample", "sr in the sample form"),
    Method<ConfigureSrResidual, nullptr, kNone>("sr-residual", "sr in the residual form"),
    Method<ConfigureSrPaper, nullptr, kNone>("sr-paper", "sr as the paper has it", true),
    Method<nullptr, ConfigureGenerationPaper, kInterpolation>("i-paper", "i as the paper has it",
                                                              true),
    Method<nullptr, ConfigureGenerationPaper, kExtrapolation>("e-paper", "e as the paper has it",
                                                              true),
    Method<ConfigureSrPaper, ConfigureGenerationPaper, kInterpolation>(
        "isr-paper", "sr-paper, then i-paper", true),
    Method<ConfigureSrPaper, ConfigureGenerationPaper, kExtrapolation>(
        "esr-paper", "sr-paper, then e-paper", true),
    Method<ConfigureBilinear, nullptr, kNone>("bilinear", "each frame from itself alone, bilinear"),
    Method<ConfigureBicubic, nullptr, kNone>("bicubic", "each frame from itself alone, bicubic"),
    Method<nullptr, nullptr, kInterpolation>("repeat", "the rendered frame before, again", false,
                                             Generator::kRepeat),
    Method<nullptr, nullptr, kInterpolation>("average", "a blend of the rendered frames around",
                                             false, Generator::kAverage),
};

}  // namespace

std::span<const MethodInfo> Methods() { return kMethods; }

const MethodInfo* FindMethod(std::string_view name) {
  for (const MethodInfo& method : kMethods) {
    if (name == method.name) return &method;
  }
  return nullptr;
}

}  // namespace warplut
