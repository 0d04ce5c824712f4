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
constexpr int kTaauBlend = IndexOf("taau_blend");
constexpr int kTaauGamma = IndexOf("taau_gamma");
constexpr int kSgsr2Weight = IndexOf("sgsr2_weight");
constexpr int kSgsr2Box = IndexOf("sgsr2_box");
constexpr int kFsr2Weight = IndexOf("fsr2_weight");
constexpr int kFsr2Box = IndexOf("fsr2_box");
constexpr int kFsr2LockRatio = IndexOf("fsr2_lock_ratio");
constexpr int kBidirTolerance = IndexOf("bidir_tolerance");
constexpr int kMeshTile = IndexOf("mesh_tile");
constexpr int kMeshTensile = IndexOf("mesh_tensile");
constexpr int kMeshShear = IndexOf("mesh_shear");

// Takes what a method decides from the defaults; the rest belongs to the caller.
template <class List, class Options>
constexpr void TakeDefaults(const List& list, Options& options) {
  const Options defaults;
  ForEachChoice(list, [&](const auto& choice) {
    if (choice.owner != ChoiceOwner::kMethod) return;
    options.*choice.option = defaults.*choice.option;
  });
}

constexpr void ConfigureSr(SuperResolutionOptions& options) {
  TakeDefaults(kSrChoices, options);
  options.peer = nullptr;
}

constexpr void ConfigureSrSample(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.form = HistoryForm::kSample;
}

constexpr void ConfigureSrResidual(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.form = HistoryForm::kResidual;
}

constexpr void ConfigureSrPaper(SuperResolutionOptions& options) {
  options.peer = nullptr;
  options.form = HistoryForm::kSample;
  options.history = true;
  options.clamp = ColorClamp::kBox;
  options.depth = DepthMeasure::kAbsolute;
  options.motion = MotionUpsampling::kDilated;
  options.motion_filter = false;
  options.current = CurrentFrame::kBilinear;
}

// What the peers take of super resolution: its planes, its dilated motion and the warp.
constexpr void ConfigurePeer(SuperResolutionOptions& options) {
  ConfigureSr(options);
  options.form = HistoryForm::kSample;
  options.clamp = ColorClamp::kNone;
  options.depth = DepthMeasure::kNone;
  options.motion = MotionUpsampling::kDilated;
}

constexpr void ConfigureTaau(SuperResolutionOptions& options) {
  ConfigurePeer(options);
  options.peer = &kTaau;
}

constexpr void ConfigureSgsr2(SuperResolutionOptions& options) {
  ConfigurePeer(options);
  options.depth = DepthMeasure::kRelative;
  options.peer = &kSgsr2;
}

constexpr void ConfigureFsr2(SuperResolutionOptions& options) {
  ConfigureSgsr2(options);
  options.peer = &kFsr2;
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
  options.peer = nullptr;
}

// The mesh moves as its camera and objects do, uniformly; where it tears the background goes on.
constexpr void ConfigureMeshWarp(FrameGenerationOptions& options) {
  ConfigureGeneration(options);
  options.peer = &kMeshWarp;
  options.motion_model = MotionModel::kLinear;
  options.refine = false;
  options.fill = DisocclusionFill::kBackground;
}

// The same passes, by one vertex for each tile.
constexpr void ConfigureMeshProjection(FrameGenerationOptions& options) {
  ConfigureMeshWarp(options);
  options.peer = &kMeshProjection;
  options.fill = DisocclusionFill::kNone;
}

// Found in the source frames, without splatting. kQuadratic: the motion of both frames is read.
constexpr void ConfigureBidirectional(FrameGenerationOptions& options) {
  ConfigureGeneration(options);
  options.peer = &kBidirectional;
  options.motion_model = MotionModel::kQuadratic;
  options.splat = false;
  options.refine = false;
}

// Without depth; the motion is that of the colours.
constexpr void ConfigureFlow(FrameGenerationOptions& options) {
  ConfigureGeneration(options);
  options.motion_model = MotionModel::kLinear;
  options.refine = false;
  options.fill = DisocclusionFill::kBackground;
  options.depth = DepthMeasure::kNone;
}

// The same, stretched over what it uncovers.
constexpr void ConfigureRubberSheet(FrameGenerationOptions& options) {
  ConfigureMeshWarp(options);
  options.fill = DisocclusionFill::kNone;
}

constexpr void ConfigureGenerationQuadratic(FrameGenerationOptions& options) {
  ConfigureGeneration(options);
  options.motion_model = MotionModel::kQuadratic;
}

constexpr void ConfigureGenerationPaper(FrameGenerationOptions& options) {
  options.peer = nullptr;
  options.motion_model = MotionModel::kQuadratic;
  options.splat = true;
  options.refine = true;
  options.fill = DisocclusionFill::kOwnMotion;
  options.depth = DepthMeasure::kAbsolute;
  options.brightness_gate = true;
  options.motion_filter = false;
}

// Its supplement's rival: uniform motion.
constexpr void ConfigureGenerationPaperUniform(FrameGenerationOptions& options) {
  ConfigureGenerationPaper(options);
  options.motion_model = MotionModel::kLinear;
}

using SrConfigure = void (*)(SuperResolutionOptions&);
using GenerationConfigure = void (*)(FrameGenerationOptions&);

struct ParameterList {
  std::array<int, kParameters.size()> indices{};
  std::size_t size = 0;

  constexpr void Add(int index) { indices[size++] = index; }
};

constexpr int kReadByTaau[] = {kTaauBlend, kTaauGamma};
constexpr int kReadBySgsr2[] = {kSgsr2Weight, kSgsr2Box};
constexpr int kReadByFsr2[] = {kFsr2Weight, kFsr2Box, kFsr2LockRatio};

// By what configures it: addresses of objects that are defined elsewhere are no constants.
constexpr std::span<const int> ReadByPeer(SrConfigure configure) {
  if (configure == ConfigureTaau) return kReadByTaau;
  if (configure == ConfigureSgsr2) return kReadBySgsr2;
  if (configure == ConfigureFsr2) return kReadByFsr2;
  return {};
}

// What the passes of configured options read; either function may be null.
constexpr ParameterList Reads(SrConfigure configure_sr, GenerationConfigure configure_generation,
                              Generation generation) {
  ParameterList list;
  if (configure_sr != nullptr) {
    SuperResolutionOptions options;
    configure_sr(options);
    if (options.history && options.depth != DepthMeasure::kNone) list.Add(kSrDepth);
    for (const int parameter : ReadByPeer(configure_sr)) list.Add(parameter);
    if (options.history && ReadByPeer(configure_sr).empty()) {
      list.Add(kBlendA);
      list.Add(kBlendB);
      if (options.clamp == ColorClamp::kVariance) list.Add(kGamma);
    }
  }
  if (configure_generation != nullptr) {
    FrameGenerationOptions options;
    configure_generation(options);
    if (options.depth != DepthMeasure::kNone) list.Add(kGenerationDepth);
    if (configure_generation == ConfigureBidirectional) list.Add(kBidirTolerance);
    if (configure_generation == ConfigureMeshProjection) {
      for (const int parameter : {kMeshTile, kMeshTensile, kMeshShear}) list.Add(parameter);
    }
    if (generation == Generation::kInterpolation && options.brightness_gate) list.Add(kBrightness);
  }
  return list;
}

constexpr bool NamesPeer(SrConfigure configure_sr, GenerationConfigure configure_generation) {
  return !ReadByPeer(configure_sr).empty() || configure_generation == ConfigureMeshWarp ||
         configure_generation == ConfigureRubberSheet ||
         configure_generation == ConfigureBidirectional ||
         configure_generation == ConfigureMeshProjection;
}

template <SrConfigure kSr, GenerationConfigure kFrames, Generation kGeneration>
constexpr ParameterList kReads = Reads(kSr, kFrames, kGeneration);

template <SrConfigure kSr, GenerationConfigure kFrames, Generation kGeneration>
constexpr MethodInfo Method(const char* name, const char* meaning, bool paper = false,
                            Generator generator = Generator::kWarped,
                            CameraSchedule cameras = CameraSchedule::kNone) {
  constexpr const ParameterList& kList = kReads<kSr, kFrames, kGeneration>;
  return {.name = name,
          .meaning = meaning,
          .super_resolution = kSr != nullptr,
          .generation = kGeneration,
          .generator = generator,
          .optical_flow = kFrames == ConfigureFlow,
          .peer = NamesPeer(kSr, kFrames),
          .cameras = cameras,
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
    Method<nullptr, ConfigureGenerationQuadratic, kInterpolation>(
        "i-quadratic", "i with motion that is quadratic on the screen"),
    Method<nullptr, ConfigureGenerationQuadratic, kExtrapolation>(
        "e-quadratic", "e with motion that is quadratic on the screen"),
    Method<ConfigureSrPaper, nullptr, kNone>("sr-paper", "sr as the paper has it", true),
    Method<nullptr, ConfigureGenerationPaper, kInterpolation>("i-paper", "i as the paper has it",
                                                              true),
    Method<nullptr, ConfigureGenerationPaper, kExtrapolation>("e-paper", "e as the paper has it",
                                                              true),
    Method<nullptr, ConfigureGenerationPaperUniform, kInterpolation>(
        "i-paper-uniform", "i-paper with uniform motion", true),
    Method<nullptr, ConfigureGenerationPaperUniform, kExtrapolation>(
        "e-paper-uniform", "e-paper with uniform motion", true),
    Method<ConfigureSrPaper, ConfigureGenerationPaper, kInterpolation>(
        "isr-paper", "sr-paper, then i-paper", true),
    Method<ConfigureSrPaper, ConfigureGenerationPaper, kExtrapolation>(
        "esr-paper", "sr-paper, then e-paper", true),
    Method<ConfigureTaau, nullptr, kNone>("taau", "temporal upsampling, a variance box"),
    Method<ConfigureSgsr2, nullptr, kNone>("sgsr2", "two passes, a bilinear history"),
    Method<ConfigureFsr2, nullptr, kNone>("fsr2", "Lanczos samples, a limited history, locks"),
    Method<ConfigureBilinear, nullptr, kNone>("bilinear", "each frame from itself alone, bilinear"),
    Method<ConfigureBicubic, nullptr, kNone>("bicubic", "each frame from itself alone, bicubic"),
    Method<nullptr, ConfigureMeshWarp, kInterpolation>("3dwarp", "a mesh of pixels, moved"),
    Method<nullptr, ConfigureMeshWarp, kExtrapolation>(
        "3dwarp-e", "3dwarp, after the later frame; background fills what it uncovers"),
    Method<nullptr, ConfigureRubberSheet, kExtrapolation>(
        "3dwarp-e-sheet", "3dwarp-e, the mesh stretched over what it uncovers"),
    Method<nullptr, ConfigureMeshProjection, kExtrapolation>(
        "mesh-e", "a mesh of one vertex for each tile, moved by motion"),
    Method<nullptr, ConfigureMeshProjection, kExtrapolation>(
        "mesh", "mesh-e by the camera of the generated frame; objects that move are drawn anew",
        false, Generator::kWarped, CameraSchedule::kOfFrame),
    Method<nullptr, ConfigureMeshProjection, kExtrapolation>(
        "mesh-between", "mesh by a camera between those of the rendered frames", false,
        Generator::kWarped, CameraSchedule::kBetween),
    Method<nullptr, ConfigureBidirectional, kInterpolation>(
        "bidir", "sources found by iteration in both frames"),
    Method<nullptr, ConfigureFlow, kInterpolation>("flow", "i by the optical flow of the colours"),
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
