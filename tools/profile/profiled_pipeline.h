// A pipeline as a profile runs it: a method of the registry whose passes can be left out one by
// one.
#pragma once

#include <vector>

#include "runtime/pipeline_configuration.h"
#include "train/replay/mode_run.h"

namespace warplut {

struct ProfiledPipeline {
  const MethodInfo* method = nullptr;  // what was asked for: it decides which frames are judged
  bool super_resolution = false;       // false: rendered frames are shown as they are
  Generator generator = Generator::kWarped;  // of generated frames, if the method has any
  SuperResolutionOptions sr;                 // meaningful with super resolution
  FrameGenerationOptions generation;         // meaningful where generated frames are warped
  std::vector<int> parameters;  // that its passes read: indices of kParameters, ascending
  bool one_grid = false;        // all content is rendered on the output grid: scale 1

  bool Generates() const { return method->generation != Generation::kNone; }
  bool WarpsFrames() const { return Generates() && generator == Generator::kWarped; }
  bool Interpolates() const {
    return WarpsFrames() && method->generation == Generation::kInterpolation;
  }
  bool Extrapolates() const {
    return WarpsFrames() && method->generation == Generation::kExtrapolation;
  }
  bool HasHistory() const { return super_resolution && sr.history; }
  bool WarpsHistory() const { return HasHistory() && sr.motion != MotionUpsampling::kStatic; }
  // Whether any warp is left, of a history or of frames; all share one filter.
  bool Warps() const { return WarpsHistory() || WarpsFrames(); }
  const WarpOptions& warp() const { return super_resolution ? sr.warp : generation.warp; }
  bool ReadsTable() const { return Warps() && warp().filter == Filter::kLut; }
  void SetWarp(const WarpOptions& warp);

  // The parameter is read no more.
  void Drop(float Parameters::*parameter);
};

// The method as its registry entry configures it, with the filter, formats and parameters of
// `options`.
ProfiledPipeline ShippedPipeline(const ModeRunOptions& options, bool one_grid);

// The same with every pass on that a profile can leave out: the brightness gate of interpolation
// and the filter of the motion too.
ProfiledPipeline FullPipeline(const ModeRunOptions& options, bool one_grid);

// RunMode of it over a clip, with the times of `options` (every, generated, alphas) and its format
// of shown frames. An Error says why the clip does not fit.
void RunPipeline(const ProfiledPipeline& pipeline, const Clip& clip, const ModeRunOptions& options,
                 Executor& executor, const ShownFrameSink& sink);

// The choices that it fixes; formats of frames stay open, and so does what it does not contain.
// `encoding`: of all content.
PipelineConfiguration ConfigurationOf(const ProfiledPipeline& pipeline, ColorEncoding encoding);

}  // namespace warplut
