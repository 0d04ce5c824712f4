#include "tools/device.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"

#ifdef WARPLUT_HAS_GPU
#include "tools/gpu_modes.h"
#endif

namespace warplut {
namespace {

constexpr const char* kCpu = "cpu";

#ifdef WARPLUT_HAS_GPU
// In the order of GpuDeviceNames.
constexpr GpuApi kApis[] = {GpuApi::kVulkan, GpuApi::kGles};

GpuApi ApiOf(const std::string& device) {
  const std::vector<std::string> names = GpuDeviceNames();
  return kApis[std::find(names.begin(), names.end(), device) - names.begin()];
}

// Owns the device that its passes run on.
class OpenedGpu final : public ModeDevice {
 public:
  explicit OpenedGpu(const std::string& name)
      : device_(OpenGpuDevice(ApiOf(name))), modes_(name, *device_) {}

  const std::string& name() const override { return modes_.name(); }
  bool IsRunnable(const SuperResolutionOptions& options, std::string* why) const override {
    return modes_.IsRunnable(options, why);
  }
  bool IsRunnable(const FrameGenerationOptions& options, std::string* why) const override {
    return modes_.IsRunnable(options, why);
  }
  std::unique_ptr<SuperResolutionPasses> MakeSuperResolution(const SuperResolutionOptions& options,
                                                             bool makes_geometry) override {
    return modes_.MakeSuperResolution(options, makes_geometry);
  }
  std::unique_ptr<FrameGenerationPasses> MakeFrameGeneration(const FrameGenerationOptions& options,
                                                             PixelFormat color) override {
    return modes_.MakeFrameGeneration(options, color);
  }

 private:
  std::unique_ptr<GpuDevice> device_;
  GpuModes modes_;
};
#endif

bool IsBuilt([[maybe_unused]] const std::string& device) {
#ifdef WARPLUT_HAS_GPU
  if (device != kCpu) return HasGpuApi(ApiOf(device));
#endif
  return device == kCpu;
}

}  // namespace

std::vector<std::string> GpuDeviceNames() { return {"vulkan", "gles"}; }

std::vector<std::string> DeviceNames() {
  std::vector<std::string> names = GpuDeviceNames();
  names.insert(names.begin(), kCpu);
  return names;
}

void CheckDevice(const std::string& device) {
  if (IsBuilt(device)) return;
  std::vector<std::string> built;
  for (const std::string& name : DeviceNames()) {
    if (IsBuilt(name)) built.push_back(name);
  }
  throw Error(fmt::format("this build has no passes for the device {}; expected {}", device,
                          fmt::join(built, " or ")));
}

std::unique_ptr<ModeDevice> OpenDevice([[maybe_unused]] const std::string& device) {
#ifdef WARPLUT_HAS_GPU
  if (device != kCpu) return std::make_unique<OpenedGpu>(device);
#endif
  return nullptr;
}

std::shared_ptr<const GpuDevice> OpenGpu([[maybe_unused]] const std::string& device) {
#ifdef WARPLUT_HAS_GPU
  return OpenGpuDevice(ApiOf(device));
#else
  return nullptr;
#endif
}

}  // namespace warplut
