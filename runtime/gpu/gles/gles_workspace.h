// The workspace of an object on OpenGL ES: textures, buffers, programs. What is recorded runs at
// once.
#pragma once

#include <vector>

#include "runtime/gpu/gles/gles_device.h"
#include "runtime/gpu/gpu_workspace.h"

namespace warplut {

class GlesWorkspace final : public GpuWorkspace {
 public:
  GlesWorkspace(const GlesDevice& device, PixelFormat format) : device_(device), format_(format) {}
  ~GlesWorkspace() override;

  void Allocate() override;
  std::byte* BytesOf(int buffer) override {
    return contents_[static_cast<std::size_t>(buffer)].data();
  }
  int AddPass(const PassPlan& plan) override;
  void Run(const std::function<void()>& record) override;
  void RecordGrid(int pass, const void* numbers, std::size_t set, int width, int height) override;
  void CopyToCorner(int buffer, int image, int width, int height) override;
  void CopyToBuffer(int image, int buffer) override;
  void FillBuffer(int buffer, std::uint32_t value) override;
  std::vector<PassTime> Times() const override { return times_; }

 private:
  struct Pass {
    PassPlan plan;
    GLuint program;
  };
  struct TimedPass {
    const char* name;
    GLuint query;
  };

  const PassPlan& PlanOf(int pass) const override {
    return passes_[static_cast<std::size_t>(pass)].plan;
  }
  void CreateTexture(const ImagePlan& plan, GLuint texture) const;
  GLuint MakeSampler(GLenum filter) const;
  void Bind(const Binding& binding, GLuint place) const;
  void ReadTimes();

  const GlesDevice& device_;
  PixelFormat format_;
  std::vector<GLuint> textures_;
  std::vector<GLuint> storage_;                   // of buffers on the device; 0 for others
  std::vector<std::vector<std::byte>> contents_;  // of the others
  GLuint nearest_ = 0, linear_ = 0;               // samplers
  GLuint numbers_ = 0;                            // the uniform block
  GLuint chunk_ = 0;                              // what buffers are filled from
  GLuint framebuffer_ = 0;                        // what images are read through
  std::vector<Pass> passes_;
  std::vector<TimedPass> run_;  // the passes of this Run
  std::vector<PassTime> times_;
};

}  // namespace warplut
