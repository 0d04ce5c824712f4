#include "tools/profile/omission.h"

namespace warplut {
namespace {

// Sets a choice where it is not yet so.
template <class T>
bool Set(T& choice, T value) {
  if (choice == value) return false;
  choice = value;
  return true;
}

void DropHistory(ProfiledPipeline& pipeline) {
  pipeline.Drop(&Parameters::sr_depth_threshold);
  pipeline.Drop(&Parameters::blend_a);
  pipeline.Drop(&Parameters::blend_b);
  pipeline.Drop(&Parameters::clamp_gamma);
}

void DropGeneration(ProfiledPipeline& pipeline) {
  pipeline.Drop(&Parameters::generation_depth_threshold);
  pipeline.Drop(&Parameters::brightness_threshold);
}

bool SuperResolution(ProfiledPipeline& pipeline) {
  if (!pipeline.super_resolution || !pipeline.one_grid) return false;
  pipeline.super_resolution = false;
  DropHistory(pipeline);
  return true;
}

template <Generator kGenerator>
bool Generate(ProfiledPipeline& pipeline) {
  const bool averages_what_is_not_there = kGenerator == Generator::kAverage &&
                                          pipeline.method->generation != Generation::kInterpolation;
  if (!pipeline.WarpsFrames() || averages_what_is_not_there) return false;
  pipeline.generator = kGenerator;
  DropGeneration(pipeline);
  return true;
}

bool History(ProfiledPipeline& pipeline) {
  if (!pipeline.HasHistory()) return false;
  pipeline.sr.history = false;
  // Generated frames still move by the motion that super resolution hands over.
  if (!pipeline.WarpsFrames()) pipeline.sr.motion_filter = false;
  DropHistory(pipeline);
  return true;
}

// Generated frames take their motion from super resolution: nothing moves in them either.
bool HistoryMotion(ProfiledPipeline& pipeline) {
  if (!pipeline.WarpsHistory()) return false;
  pipeline.sr.motion = MotionUpsampling::kStatic;
  pipeline.sr.motion_filter = false;
  pipeline.Drop(&Parameters::sr_depth_threshold);
  return true;
}

// From the dearest to the cheapest.
constexpr int Cost(MotionUpsampling motion) {
  switch (motion) {
    case MotionUpsampling::kStatic:
      return 0;
    case MotionUpsampling::kNearest:
      return 1;
    case MotionUpsampling::kDilated:
      return 2;
    case MotionUpsampling::kEdgeAware:
      return 3;
  }
  return 0;
}

template <MotionUpsampling kMotion>
bool Upsample(ProfiledPipeline& pipeline) {
  // Without a history the motion is upsampled for generated frames alone.
  const bool upsamples =
      pipeline.WarpsHistory() || (pipeline.super_resolution && pipeline.WarpsFrames());
  if (!upsamples || Cost(pipeline.sr.motion) <= Cost(kMotion)) return false;
  pipeline.sr.motion = kMotion;
  return true;
}

bool MotionFilter(ProfiledPipeline& pipeline) {
  if (pipeline.super_resolution) return Set(pipeline.sr.motion_filter, false);
  return pipeline.WarpsFrames() && Set(pipeline.generation.motion_filter, false);
}

constexpr int Cost(const WarpOptions& warp) {
  switch (warp.filter) {
    case Filter::kBilinear:
      return 0;
    case Filter::kCatmullRom:
    case Filter::kKeys:
      return 1;
    case Filter::kSpline:
      return 2;
    case Filter::kLut:
      return warp.lookup == Lookup::kNearest ? 2 : 3;
  }
  return 0;
}

bool Filters(ProfiledPipeline& pipeline, const WarpOptions& warp) {
  if (!pipeline.Warps() || Cost(pipeline.warp()) <= Cost(warp)) return false;
  pipeline.SetWarp(warp);
  return true;
}

bool BilinearFilter(ProfiledPipeline& pipeline) {
  return Filters(pipeline, {.filter = Filter::kBilinear});
}
bool CubicFilter(ProfiledPipeline& pipeline) {
  return Filters(pipeline, {.filter = Filter::kCatmullRom});
}
bool NearestLookup(ProfiledPipeline& pipeline) {
  WarpOptions warp = pipeline.warp();
  if (warp.filter != Filter::kLut) return false;
  warp.lookup = Lookup::kNearest;
  return Filters(pipeline, warp);
}

bool AdaptiveForm(ProfiledPipeline& pipeline) {
  if (!pipeline.HasHistory() || pipeline.sr.form != HistoryForm::kAdaptive) return false;
  pipeline.sr.form = HistoryForm::kResidual;
  return true;
}

bool SampleForm(ProfiledPipeline& pipeline) {
  return pipeline.HasHistory() && Set(pipeline.sr.form, HistoryForm::kSample);
}

bool SrDepthGate(ProfiledPipeline& pipeline) {
  if (!pipeline.WarpsHistory() || !Set(pipeline.sr.depth, DepthMeasure::kNone)) return false;
  pipeline.Drop(&Parameters::sr_depth_threshold);
  return true;
}

bool ColorBox(ProfiledPipeline& pipeline) {
  if (!pipeline.HasHistory() || !Set(pipeline.sr.clamp, ColorClamp::kNone)) return false;
  pipeline.Drop(&Parameters::clamp_gamma);
  return true;
}

bool VarianceBox(ProfiledPipeline& pipeline) {
  if (!pipeline.HasHistory() || pipeline.sr.clamp != ColorClamp::kVariance) return false;
  pipeline.sr.clamp = ColorClamp::kBox;
  pipeline.Drop(&Parameters::clamp_gamma);
  return true;
}

bool HalfFloatHistory(ProfiledPipeline& pipeline) {
  return pipeline.HasHistory() && Set(pipeline.sr.history_format, PixelFormat::kRgba8);
}

bool BicubicFrame(ProfiledPipeline& pipeline) {
  return pipeline.super_resolution && Set(pipeline.sr.current, CurrentFrame::kBilinear);
}

bool Splat(ProfiledPipeline& pipeline) {
  return pipeline.WarpsFrames() && Set(pipeline.generation.splat, false);
}

bool Refinement(ProfiledPipeline& pipeline) {
  return pipeline.WarpsFrames() && pipeline.generation.splat &&
         Set(pipeline.generation.refine, false);
}

bool DisocclusionFilling(ProfiledPipeline& pipeline) {
  return pipeline.Extrapolates() && pipeline.generation.splat &&
         Set(pipeline.generation.fill, DisocclusionFill::kNone);
}

bool PerspectiveMotion(ProfiledPipeline& pipeline) {
  if (!pipeline.WarpsFrames() || pipeline.generation.motion_model != MotionModel::kPerspective) {
    return false;
  }
  pipeline.generation.motion_model = MotionModel::kQuadratic;
  return true;
}

bool QuadraticMotion(ProfiledPipeline& pipeline) {
  return pipeline.WarpsFrames() && Set(pipeline.generation.motion_model, MotionModel::kLinear);
}

bool GenerationDepthGate(ProfiledPipeline& pipeline) {
  if (!pipeline.WarpsFrames() || !Set(pipeline.generation.depth, DepthMeasure::kNone)) return false;
  pipeline.Drop(&Parameters::generation_depth_threshold);
  return true;
}

bool BrightnessGate(ProfiledPipeline& pipeline) {
  if (!pipeline.Interpolates() || !Set(pipeline.generation.brightness_gate, false)) return false;
  pipeline.Drop(&Parameters::brightness_threshold);
  return true;
}

constexpr Omission kOmissions[] = {
    {"super-resolution", "at scale 1, rendered frames are shown as they are", SuperResolution},
    {"generation", "generated frames repeat the frame before", Generate<Generator::kRepeat>},
    {"moved-generation", "generated frames are blends of the frames around, unmoved",
     Generate<Generator::kAverage>},
    {"history", "every frame from itself alone", History},
    {"history-motion",
     "the history stays where it was, and so do generated frames: no motion, no depth",
     HistoryMotion},
    {"splat", "every pixel takes its own motion, unsplatted", Splat},
    {"table-and-cubic", "warps by the bilinear filter", BilinearFilter},
    {"table", "warps by Catmull-Rom", CubicFilter},
    {"table-interpolation", "the nearest node of the table, not the four around", NearestLookup},
    {"motion-filter", "motion as it is given, quantised or not", MotionFilter},
    {"motion-upsampling", "the motion of the nearest sample", Upsample<MotionUpsampling::kNearest>},
    {"edge-awareness", "the motion of the nearest surface among 3 x 3 samples",
     Upsample<MotionUpsampling::kDilated>},
    {"color-box", "history is not limited to the colours around", ColorBox},
    {"variance-box", "history is limited to the least and greatest colour, not by the variance",
     VarianceBox},
    {"adaptive-form", "the history is updated alike where samples alias and where they do not",
     AdaptiveForm},
    {"residual-form", "samples enter as themselves, not as differences from the history",
     SampleForm},
    {"history-depth-gate", "history is not rejected by depth", SrDepthGate},
    {"half-float-history", "a history of 8 bits", HalfFloatHistory},
    {"bicubic-frame", "the current frame alone is interpolated bilinearly", BicubicFrame},
    {"perspective-motion", "generated frames move by their motion on the screen, without depth",
     PerspectiveMotion},
    {"quadratic-motion", "generated frames move linearly", QuadraticMotion},
    {"refinement", "gaps of the splatted motion count as disocclusions", Refinement},
    {"disocclusion-filling", "disocclusions of extrapolation show the frame as it is",
     DisocclusionFilling},
    {"generation-depth-gate", "generated frames blend without comparing depth",
     GenerationDepthGate},
    {"brightness-gate", "interpolated frames blend where brightness differs too", BrightnessGate},
};

}  // namespace

std::span<const Omission> Omissions() { return kOmissions; }

}  // namespace warplut
