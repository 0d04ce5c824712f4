// What the options of a pipeline come to, as the passes ask for it. Where the build contains one
// value alone (runtime/pipeline.h) an answer is a constant, and the compiler leaves out what the
// others would need.
#pragma once

#include "runtime/core/strict_math.h"
#include "runtime/frame_generation.h"
#include "runtime/pipeline.h"
#include "runtime/super_resolution.h"

namespace warplut {

// Super resolution.
constexpr bool IsReference(const SuperResolutionOptions& o) {
  return kPipeline.reference && o.reference;
}
constexpr bool KeepsHistory(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.history, o.history);
}
constexpr HistoryForm FormOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.form, o.form);
}
constexpr ColorClamp ClampOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.clamp, o.clamp);
}
constexpr MotionUpsampling MotionOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.motion, o.motion);
}
// Whether motion and depth are read.
constexpr bool ReadsMotion(const SuperResolutionOptions& o) {
  return MotionOf(o) != MotionUpsampling::kStatic;
}
constexpr bool FiltersMotion(const SuperResolutionOptions& o) {
  return ReadsMotion(o) && Choose(kPipeline.sr.motion_filter, o.motion_filter);
}
// Whether the history is found by motion: otherwise there is none, or it lies where it was.
constexpr bool WarpsHistory(const SuperResolutionOptions& o) {
  return KeepsHistory(o) && ReadsMotion(o);
}
// Whether the history is turned into coefficients before it is warped.
inline bool PrefiltersHistory(const SuperResolutionOptions& o) {
  return kContainsPrefilter && WarpsHistory(o) && HasPrefilter(PrefilterOf(o.warp));
}
constexpr bool HasResidual(const SuperResolutionOptions& o) {
  return KeepsHistory(o) && FormOf(o) != HistoryForm::kSample;
}
// Whether the history is updated smoother where samples alias.
constexpr bool SmoothsAliasing(const SuperResolutionOptions& o) {
  return KeepsHistory(o) && FormOf(o) == HistoryForm::kAdaptive;
}
constexpr DepthMeasure DepthOf(const SuperResolutionOptions& o) {
  return WarpsHistory(o) ? Choose(kPipeline.sr.depth, o.depth) : DepthMeasure::kNone;
}
// Whether the reactive mask is read.
constexpr bool ReadsReactive(const SuperResolutionOptions& o) {
  return KeepsHistory(o) && o.reactive;
}
constexpr CurrentFrame CurrentOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.current, o.current);
}
constexpr PixelFormat HistoryFormatOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.history_format, o.history_format);
}
constexpr ColorEncoding EncodingOf(const SuperResolutionOptions& o) {
  return Choose(kPipeline.sr.encoding, o.encoding);
}

// Frame generation.
constexpr bool IsReference(const FrameGenerationOptions& o) {
  return kPipeline.reference && o.reference;
}
constexpr MotionModel ModelOf(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.motion_model, o.motion_model);
}
constexpr bool Splats(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.splat, o.splat);
}
constexpr bool Refines(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.refine, o.refine);
}
constexpr DisocclusionFill FillOf(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.fill, o.fill);
}
constexpr DepthMeasure DepthOf(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.depth, o.depth);
}
constexpr bool GatesBrightness(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.brightness_gate, o.brightness_gate);
}
constexpr bool FiltersMotion(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.motion_filter, o.motion_filter);
}
// Whether the frames are turned into coefficients before they are warped.
inline bool PrefiltersFrames(const FrameGenerationOptions& o) {
  return kContainsPrefilter && HasPrefilter(PrefilterOf(o.warp));
}
constexpr ColorEncoding EncodingOf(const FrameGenerationOptions& o) {
  return Choose(kPipeline.generation.encoding, o.encoding);
}

}  // namespace warplut
