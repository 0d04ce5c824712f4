#include "runtime/gpu/gpu_device.h"

#ifdef WARPLUT_HAS_VULKAN
#include "runtime/gpu/vulkan/vulkan_device.h"
#endif
#ifdef WARPLUT_HAS_GLES
#include "runtime/gpu/gles/gles_device.h"
#endif

namespace warplut {

bool HasGpuApi(GpuApi api) {
#ifdef WARPLUT_HAS_VULKAN
  if (api == GpuApi::kVulkan) return true;
#endif
#ifdef WARPLUT_HAS_GLES
  if (api == GpuApi::kGles) return true;
#endif
  return false;
}

std::unique_ptr<GpuDevice> OpenGpuDevice(GpuApi api,
                                         [[maybe_unused]] const DeviceOptions& options) {
#ifdef WARPLUT_HAS_VULKAN
  if (api == GpuApi::kVulkan) return std::make_unique<VulkanDevice>(options);
#endif
#ifdef WARPLUT_HAS_GLES
  if (api == GpuApi::kGles) return std::make_unique<GlesDevice>(options);
#endif
  throw GpuError("this build lacks the API of the GPU that was asked for");
}

}  // namespace warplut
