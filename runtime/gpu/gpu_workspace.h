// Images, buffers and passes of one object on a GPU: described once, made and run by the host of an
// API.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/gpu/gpu_device.h"
#include "runtime/gpu/shader_code.h"

namespace warplut {

struct ImagePlan {
  TexelFormat format = TexelFormat::kRgba32F;
  int width = 0, height = 0;
  int layers = 0;  // > 0 makes an array

  // Of all texels, without padding.
  std::size_t bytes() const;
};

struct BufferPlan {
  std::size_t size = 0;
  bool on_device = false;  // only shaders see it
};

// A resource at the next binding of a pass.
struct Binding {
  enum class Use : std::uint8_t { kSampled, kFiltered, kStored, kBuffer };
  int index;
  Use use;
};
constexpr Binding Sampled(int image) { return {image, Binding::Use::kSampled}; }
// Linear between texels; of RGBA16F.
constexpr Binding Filtered(int image) { return {image, Binding::Use::kFiltered}; }
constexpr Binding Stored(int image) { return {image, Binding::Use::kStored}; }
constexpr Binding Buffer(int buffer) { return {buffer, Binding::Use::kBuffer}; }

struct PassPlan {
  const char* name = "";
  Shader shader = Shader::kPrefilter;
  // constant_id 0, 1, ...; booleans are 0 or 1. Those that the shader lacks do nothing.
  std::vector<std::int32_t> constants;
  // Bindings 0, 1, ... of each set of resources that the pass is run with: buffers and images that
  // are stored to first, as OpenGL ES has few places for them. All sets have the same uses.
  std::vector<std::vector<Binding>> sets;
  std::size_t numbers_bytes = 0;  // of the push constants
  int width = 0, height = 0;      // of the whole grid
  int group_width = 8, group_height = 8;

  // Groups that cover a grid of that side.
  int groups_x(int grid_width) const { return (grid_width + group_width - 1) / group_width; }
  int groups_y(int grid_height) const { return (grid_height + group_height - 1) / group_height; }
};

struct PassTime {
  std::string pass;
  double milliseconds = 0;
};

class GpuWorkspace {
 public:
  virtual ~GpuWorkspace() = default;
  GpuWorkspace(const GpuWorkspace&) = delete;
  GpuWorkspace& operator=(const GpuWorkspace&) = delete;

  // Before Allocate: the index of the new image or buffer.
  int AddImage(const ImagePlan& plan);
  int AddBuffer(const BufferPlan& plan);
  // The buffer, which the processor sees, from or to which the image is copied.
  int AddBufferOf(int image) { return AddBuffer({.size = this->image(image).bytes()}); }

  const ImagePlan& image(int i) const { return images_[static_cast<std::size_t>(i)]; }
  const BufferPlan& buffer(int i) const { return buffers_[static_cast<std::size_t>(i)]; }
  // Bytes of all images and buffers, without padding.
  std::size_t bytes() const;

  // Memory for all that was added; once. A GpuError where it cannot be had.
  virtual void Allocate() = 0;
  // What the processor sees of a buffer.
  virtual std::byte* BytesOf(int buffer) = 0;
  // After Allocate: the index of the new pass. A GpuError if the device does not take the shader.
  virtual int AddPass(const PassPlan& plan) = 0;

  // Runs what `record` records by the functions below, in their order, and waits for its end. A
  // GpuError if the device fails.
  virtual void Run(const std::function<void()>& record) = 0;
  // A pass over the first width x height pixels of its grid; nothing if it is negative. What it
  // stored can be read by the next ones.
  virtual void RecordGrid(int pass, const void* numbers, std::size_t set, int width,
                          int height) = 0;
  // Over its whole grid.
  void Record(int pass, const void* numbers, std::size_t set = 0);
  // The first width x height texels of an image, whose rows follow each other in the buffer.
  virtual void CopyToCorner(int buffer, int image, int width, int height) = 0;
  void CopyToImage(int buffer, int image);
  virtual void CopyToBuffer(int image, int buffer) = 0;
  // Every word of a buffer becomes `value`.
  virtual void FillBuffer(int buffer, std::uint32_t value) = 0;

  // Times of the passes of the last Run; empty where the device has none.
  virtual std::vector<PassTime> Times() const = 0;

 protected:
  GpuWorkspace() = default;
  const std::vector<ImagePlan>& images() const { return images_; }
  const std::vector<BufferPlan>& buffers() const { return buffers_; }
  virtual const PassPlan& PlanOf(int pass) const = 0;

 private:
  std::vector<ImagePlan> images_;
  std::vector<BufferPlan> buffers_;
};

}  // namespace warplut
