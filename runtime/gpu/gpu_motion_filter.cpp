#include "runtime/gpu/gpu_motion_filter.h"

#include "runtime/motion/camera_rounds.h"

namespace warplut {
namespace {

// Coefficients, and a limit for each axis.
constexpr std::size_t kCameraFloats = kCameraUnknowns + 2;

// constant_id of DEPTH_BUFFER in shaders/formulas.glsl; the passes read no other.
constexpr std::size_t kDepthBufferConstant = 11;

}  // namespace

int AddCameraBuffer(GpuWorkspace& workspace) {
  return workspace.AddBuffer({kCameraFloats * sizeof(float), true});
}

MotionFilterPasses::MotionFilterPasses(float limit, const InputConventions& conventions, int camera,
                                       const std::vector<Images>& sets, GpuWorkspace& workspace) {
  std::vector<std::int32_t> constants(kDepthBufferConstant, 0);
  constants.push_back(conventions.depth_buffer ? 1 : 0);
  PassPlan plan = {.name = "camera",
                   .shader = Shader::kCamera,
                   .constants = constants,
                   .sets = {},
                   .numbers_bytes = sizeof(MotionFilterNumbers),
                   .width = 1,
                   .height = 1};
  for (const Images& images : sets)
    plan.sets.push_back({Buffer(camera), Sampled(images.depth), Sampled(images.motion)});
  camera_ = workspace.AddPass(plan);
  const ImagePlan& image = workspace.image(sets.front().motion);
  plan.name = "motion filter";
  plan.shader = Shader::kMotionFilter;
  plan.width = image.width;
  plan.height = image.height;
  plan.sets.clear();
  for (const Images& images : sets) {
    plan.sets.push_back(
        {Buffer(camera), Stored(images.filtered), Sampled(images.depth), Sampled(images.motion)});
  }
  filter_ = workspace.AddPass(plan);
  numbers_ = {.size = {0, 0},
              .motion_scale = MotionScaleOf(conventions),
              .depth_a = conventions.depth_a,
              .depth_b = conventions.depth_b,
              .limit = limit,
              .sample_step = 0};
}

void MotionFilterPasses::Record(std::size_t set, int width, int height,
                                GpuWorkspace& workspace) const {
  if (camera_ < 0) return;
  MotionFilterNumbers numbers = numbers_;
  numbers.size = {width, height};
  numbers.sample_step = CameraSampleStep(width, height);
  workspace.Record(camera_, &numbers, set);
  workspace.RecordGrid(filter_, &numbers, set, width, height);
}

}  // namespace warplut
