// A device that computes, whatever its API: Vulkan (runtime/gpu/vulkan) or OpenGL ES
// (runtime/gpu/gles).
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/gpu/texel_format.h"

namespace warplut {

class GpuWorkspace;

// One sentence: there is no device, it lacks something, or it failed.
class GpuError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class GpuApi : std::uint8_t { kVulkan, kGles };

struct DeviceOptions {
  // Collects what the API tells of wrong calls: of Vulkan the messages of
  // VK_LAYER_KHRONOS_validation, of OpenGL ES those of a debug context. A GpuError where that is
  // not there.
  bool validate = false;
};

class GpuDevice {
 public:
  virtual ~GpuDevice() = default;
  GpuDevice(const GpuDevice&) = delete;
  GpuDevice& operator=(const GpuDevice&) = delete;

  virtual const std::string& name() const = 0;
  // The largest side of an image.
  virtual int largest_image() const = 0;
  // Bytes of the largest buffer that shaders see.
  virtual std::size_t largest_buffer() const = 0;
  // Whether passes are timed.
  virtual bool has_times() const = 0;
  // What was told of wrong calls so far.
  virtual const std::vector<std::string>& messages() const = 0;
  // Whether images of this format can be stored to by shaders, sampled and copied.
  virtual bool CanStore(TexelFormat format) const = 0;
  // `format` is that of intermediate colours, kRgba16F or kRgba32F. The device outlives the result.
  virtual std::unique_ptr<GpuWorkspace> MakeWorkspace(PixelFormat format) const = 0;

 protected:
  GpuDevice() = default;
};

// Whether the build has the API.
bool HasGpuApi(GpuApi api);

// Opens a device. HasGpuApi holds. A GpuError where there is none. At most one device of an API
// exists at a time.
std::unique_ptr<GpuDevice> OpenGpuDevice(GpuApi api, const DeviceOptions& options = {});

}  // namespace warplut
