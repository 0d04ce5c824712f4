// An OpenGL ES 3.2 context for compute, without a surface: it needs no window and no display
// server.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "runtime/gpu/gles/gles_api.h"
#include "runtime/gpu/gpu_device.h"

namespace warplut {

class GlesDevice final : public GpuDevice {
 public:
  // The device that the driver takes by default. A GpuError where there is none, or none of version
  // 3.2.
  explicit GlesDevice(const DeviceOptions& options = {});
  ~GlesDevice() override;

  const std::string& name() const override { return name_; }
  int largest_image() const override { return largest_image_; }
  std::size_t largest_buffer() const override { return largest_buffer_; }
  bool has_times() const override { return has_times_; }
  const std::vector<std::string>& messages() const override { return messages_; }
  // What every device of version 3.1 stores to.
  bool CanStore(TexelFormat format) const override { return IsStored(format); }
  std::unique_ptr<GpuWorkspace> MakeWorkspace(PixelFormat format) const override;

  const GlesApi& gl() const { return gl_; }
  // In Current: a GpuError if a call since the last Check failed; `what` was tried ("to run a
  // frame").
  void Check(const std::string& what) const;

  // While it exists the context is the calling thread's, and no other thread's. One at a time.
  class Current {
   public:
    explicit Current(const GlesDevice& device);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    const GlesDevice& device_;
    const std::lock_guard<std::mutex> lock_;
  };

 private:
  void CreateContext(const DeviceOptions& options);
  void ReadLimits();
  void Destroy();

  const EglApi egl_;
  GlesApi gl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  mutable std::mutex mutex_;
  int largest_image_ = 0;
  std::size_t largest_buffer_ = 0;
  bool has_times_ = false;
  std::string name_;
  std::vector<std::string> messages_;
};

}  // namespace warplut
