#include "runtime/gpu/gpu_workspace.h"

#include <algorithm>

namespace warplut {

std::size_t ImagePlan::bytes() const {
  return TexelBytes(format) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
         static_cast<std::size_t>(std::max(layers, 1));
}

int GpuWorkspace::AddImage(const ImagePlan& plan) {
  images_.push_back(plan);
  return static_cast<int>(images_.size()) - 1;
}

int GpuWorkspace::AddBuffer(const BufferPlan& plan) {
  buffers_.push_back(plan);
  return static_cast<int>(buffers_.size()) - 1;
}

void GpuWorkspace::Record(int pass, const void* numbers, std::size_t set) {
  if (pass < 0) return;
  RecordGrid(pass, numbers, set, PlanOf(pass).width, PlanOf(pass).height);
}

void GpuWorkspace::CopyToImage(int buffer, int image) {
  CopyToCorner(buffer, image, this->image(image).width, this->image(image).height);
}

std::size_t GpuWorkspace::bytes() const {
  std::size_t bytes = 0;
  for (const ImagePlan& image : images_) bytes += image.bytes();
  for (const BufferPlan& buffer : buffers_) bytes += buffer.size;
  return bytes;
}

}  // namespace warplut
