#include "tools/device_run.h"

#include <fmt/format.h>

#include <chrono>

#include "datasets/error.h"

#ifdef WARPLUT_HAS_GPU
#include "runtime/gpu/gpu_super_resolution.h"
#endif

namespace warplut {
namespace {

constexpr const char* kCpu = "cpu";
constexpr const char* kVulkan = "vulkan";

bool RunsOnGpu(const MethodInfo& method) {
  return method.super_resolution && method.generation == Generation::kNone && !method.peer;
}

#ifdef WARPLUT_HAS_GPU
void RunOnVulkan(const Clip& clip, const ModeRunOptions& options, const ShownFrameSink& sink) {
  const VulkanDevice device;
  const SuperResolutionOptions effective = EffectiveSuperResolution(clip, options);
  std::string why;
  if (!GpuSuperResolution::IsRunnable(device, effective, &why)) throw Error(why);
  GpuSuperResolution super_resolution(device, effective);
  const bool linear = clip.encoding == ColorEncoding::kLinearHdr;
  const bool wide = linear && options.shown_format == PixelFormat::kRgba8;
  ImageBuffer shown(clip.output.width, clip.output.height,
                    wide ? PixelFormat::kRgba16F : options.shown_format);
  const ImageBuffer no_depth(clip.render.width, clip.render.height, PixelFormat::kR32F);
  const MotionBuffer no_motion(clip.render.width, clip.render.height);
  for (int i = 0; i < static_cast<int>(clip.frames.size()); i += options.every) {
    RenderedFrame frame = clip.frames[static_cast<std::size_t>(i)].Rendered();
    if (!HasHistory(*options.method)) {
      frame.depth = no_depth.view();
      frame.motion = no_motion.view();
    }
    const auto start = std::chrono::steady_clock::now();
    super_resolution.Process(frame, shown.view());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    sink({.time = static_cast<double>(i),
          .frame = i,
          .image = static_cast<const ImageBuffer&>(shown).view(),
          .seconds = taken.count()});
  }
}
#endif

}  // namespace

std::vector<std::string> DeviceNames() { return {kCpu, kVulkan}; }

void CheckDevice(const std::string& device, const MethodInfo& method) {
  if (device == kCpu) return;
#ifndef WARPLUT_HAS_GPU
  throw Error(fmt::format("this build has no passes for the device {}; expected {}", device, kCpu));
#endif
  if (RunsOnGpu(method)) return;
  std::string names;
  for (const MethodInfo& other : Methods()) {
    if (RunsOnGpu(other)) names += fmt::format("{}{}", names.empty() ? "" : ", ", other.name);
  }
  throw Error(fmt::format("the device {} has no passes for the method {}; it has those of {}",
                          device, method.name, names));
}

void RunModeOn(const std::string& device, const Clip& clip, const ModeRunOptions& options,
               Executor& executor, const ShownFrameSink& sink) {
  if (device == kCpu) {
    RunMode(clip, options, executor, sink);
    return;
  }
#ifdef WARPLUT_HAS_GPU
  RunOnVulkan(clip, options, sink);
#endif
}

}  // namespace warplut
