// The passes of one object: made of shaders and resources, recorded one after the other, timed.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/gpu/compute_pass.h"
#include "runtime/gpu/gpu_commands.h"
#include "runtime/gpu/shader_code.h"

namespace warplut {

struct PassTime {
  std::string pass;
  double milliseconds = 0;
};

// A resource of GpuResources at the next binding of a pass.
struct Binding {
  enum class Use : std::uint8_t { kSampled, kStored, kBuffer };
  int index;
  Use use;
};
constexpr Binding Sampled(int image) { return {image, Binding::Use::kSampled}; }
constexpr Binding Stored(int image) { return {image, Binding::Use::kStored}; }
constexpr Binding Buffer(int buffer) { return {buffer, Binding::Use::kBuffer}; }

struct PassPlan {
  const char* name = "";
  Shader shader;
  std::vector<std::int32_t> constants;  // of PassOptions
  // One list of bindings for each set of resources that the pass is run with.
  std::vector<std::vector<Binding>> sets;
  std::size_t numbers_bytes = 0;
  int width = 0, height = 0;  // of the grid
  int group_width = 8, group_height = 8;
};

class PassSequence {
 public:
  // For images of the format that intermediate colours have. `resources` are allocated before Add,
  // and outlive the object.
  PassSequence(const VulkanDevice& device, const GpuResources& resources, PixelFormat format);
  ~PassSequence();
  PassSequence(const PassSequence&) = delete;
  PassSequence& operator=(const PassSequence&) = delete;

  // The index of the new pass. A GpuError if the device does not take the shader.
  int Add(const PassPlan& plan);

  // Records what `record` does, runs it and waits for its end.
  void Run(const std::function<void(VkCommandBuffer)>& record);
  // In Run: records a pass. Nothing if `pass` is negative.
  void Record(VkCommandBuffer commands, int pass, const void* numbers, std::size_t set = 0);

  // Times of the passes of the last Run; empty where the device has no timestamps.
  std::vector<PassTime> Times() const;

 private:
  const VulkanDevice& device_;
  const GpuResources& resources_;
  PixelFormat format_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  GpuCommands commands_;
  std::vector<std::unique_ptr<ComputePass>> passes_;
  std::vector<const char*> run_;  // names of the passes of the last Run
};

}  // namespace warplut
