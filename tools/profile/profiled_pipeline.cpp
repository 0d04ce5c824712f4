#include "tools/profile/profiled_pipeline.h"

#include <algorithm>
#include <string>

#include "datasets/error.h"

namespace warplut {
namespace {

// The options are given whole: nothing is configured on top of them.
void KeepSuperResolution(SuperResolutionOptions&) {}
void KeepGeneration(FrameGenerationOptions&) {}

// The index in kParameters.
int IndexOf(float Parameters::*parameter) {
  const auto found =
      std::find_if(kParameters.begin(), kParameters.end(),
                   [&](const ParameterInfo& info) { return info.member == parameter; });
  return static_cast<int>(found - kParameters.begin());
}

SuperResolutionConfiguration SuperResolutionChoices(const ProfiledPipeline& pipeline,
                                                    ColorEncoding encoding) {
  const SuperResolutionOptions& options = pipeline.sr;
  SuperResolutionConfiguration choices;
  choices.history = options.history;
  if (pipeline.HasHistory()) {
    choices.form = options.form;
    choices.clamp = options.clamp;
    choices.history_format = options.history_format;
  }
  if (pipeline.WarpsHistory()) choices.depth = options.depth;
  if (pipeline.HasHistory() || pipeline.WarpsFrames()) {
    choices.motion = options.motion;
    choices.motion_filter = options.motion_filter;
  }
  choices.current = options.current;
  choices.encoding = encoding;
  return choices;
}

FrameGenerationConfiguration GenerationChoices(const ProfiledPipeline& pipeline,
                                               ColorEncoding encoding) {
  const FrameGenerationOptions& options = pipeline.generation;
  FrameGenerationConfiguration choices;
  choices.motion_model = options.motion_model;
  choices.splat = options.splat;
  if (options.splat) choices.refine = options.refine;
  if (options.splat && pipeline.Extrapolates()) choices.fill = options.fill;
  choices.depth = options.depth;
  if (pipeline.Interpolates()) choices.brightness_gate = options.brightness_gate;
  choices.motion_filter = options.motion_filter;
  choices.encoding = encoding;
  return choices;
}

}  // namespace

void ProfiledPipeline::SetWarp(const WarpOptions& warp) {
  sr.warp = warp;
  generation.warp = warp;
}

void ProfiledPipeline::Drop(float Parameters::*parameter) {
  std::erase(parameters, IndexOf(parameter));
}

ProfiledPipeline ShippedPipeline(const ModeRunOptions& options, bool one_grid) {
  const MethodInfo& method = *options.method;
  ProfiledPipeline pipeline{.method = &method,
                            .super_resolution = method.super_resolution,
                            .generator = method.generator,
                            .sr = options.super_resolution,
                            .generation = options.generation,
                            .parameters = {method.parameters.begin(), method.parameters.end()},
                            .one_grid = one_grid};
  if (method.configure_super_resolution != nullptr) method.configure_super_resolution(pipeline.sr);
  if (method.configure_generation != nullptr) method.configure_generation(pipeline.generation);
  if (method.paper) pipeline.sr.parameters = pipeline.generation.parameters = kPaperParameters;
  return pipeline;
}

ProfiledPipeline FullPipeline(const ModeRunOptions& options, bool one_grid) {
  ProfiledPipeline pipeline = ShippedPipeline(options, one_grid);
  if (pipeline.super_resolution) {
    pipeline.sr.motion_filter = pipeline.sr.history;
  } else {
    pipeline.generation.motion_filter = pipeline.WarpsFrames();
  }
  if (pipeline.Interpolates() && !pipeline.generation.brightness_gate) {
    pipeline.generation.brightness_gate = true;
    pipeline.parameters.push_back(IndexOf(&Parameters::brightness_threshold));
    std::sort(pipeline.parameters.begin(), pipeline.parameters.end());
  }
  return pipeline;
}

void RunPipeline(const ProfiledPipeline& pipeline, const Clip& clip, const ModeRunOptions& options,
                 Executor& executor, const ShownFrameSink& sink) {
  MethodInfo method = *pipeline.method;
  method.super_resolution = pipeline.super_resolution;
  method.generator = pipeline.generator;
  method.paper = false;
  method.configure_super_resolution = pipeline.super_resolution ? KeepSuperResolution : nullptr;
  method.configure_generation = pipeline.WarpsFrames() ? KeepGeneration : nullptr;
  ModeRunOptions run = options;
  run.method = &method;
  run.super_resolution = pipeline.sr;
  run.generation = pipeline.generation;
  std::string why;
  if (!run.IsValid(clip, &why)) throw Error(why);
  RunMode(clip, run, executor, sink);
}

PipelineConfiguration ConfigurationOf(const ProfiledPipeline& pipeline, ColorEncoding encoding) {
  PipelineConfiguration configuration;
  configuration.super_resolution = pipeline.super_resolution;
  configuration.interpolation = pipeline.Interpolates();
  configuration.extrapolation = pipeline.Extrapolates();
  configuration.reference = false;
  configuration.peers = pipeline.sr.peer != nullptr;
  if (pipeline.Warps() && !configuration.peers) {
    configuration.filter = pipeline.warp().filter;
    if (pipeline.ReadsTable()) configuration.lookup = pipeline.warp().lookup;
  }
  if (pipeline.super_resolution) configuration.sr = SuperResolutionChoices(pipeline, encoding);
  if (pipeline.WarpsFrames()) configuration.generation = GenerationChoices(pipeline, encoding);
  return configuration;
}

}  // namespace warplut
