// Pixels and motion that the runtime owns: allocated once, rows aligned for vectors.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

#include "luts/visibility.h"
#include "runtime/image_view.h"

namespace WARPLUT_PUBLIC warplut {

// Alignment of the first pixel of every row, in bytes; rows end in padding up to it.
inline constexpr std::size_t kRowAlignment = 64;

struct AlignedDelete {
  void operator()(std::byte* bytes) const {
    ::operator delete[](bytes, std::align_val_t{kRowAlignment});
  }
};

// Zero-filled bytes in rows. std::bad_alloc if they cannot be had.
class RowBuffer {
 public:
  RowBuffer() = default;
  RowBuffer(std::size_t row_bytes, int rows)
      : stride_((row_bytes + kRowAlignment - 1) / kRowAlignment * kRowAlignment),
        size_(stride_ * static_cast<std::size_t>(rows)),
        bytes_(static_cast<std::byte*>(::operator new[](size_, std::align_val_t{kRowAlignment}))) {
    Clear();
  }

  void Clear() { std::memset(bytes_.get(), 0, size_); }
  std::byte* data() const { return bytes_.get(); }
  std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }
  std::size_t size() const { return size_; }  // bytes

 private:
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
  std::unique_ptr<std::byte[], AlignedDelete> bytes_;
};

class ImageBuffer {
 public:
  ImageBuffer() = default;
  ImageBuffer(int width, int height, PixelFormat format)
      : width_(width),
        height_(height),
        format_(format),
        rows_(static_cast<std::size_t>(width) * BytesPerPixel(format), height) {}

  operator ImageView() const { return {rows_.data(), width_, height_, rows_.stride(), format_}; }
  operator MutableImageView() { return {rows_.data(), width_, height_, rows_.stride(), format_}; }
  ImageView view() const { return *this; }
  MutableImageView view() { return *this; }
  void Clear() { rows_.Clear(); }
  std::size_t bytes() const { return rows_.size(); }

 private:
  int width_ = 0;
  int height_ = 0;
  PixelFormat format_ = PixelFormat::kRgba8;
  RowBuffer rows_;
};

class MotionBuffer {
 public:
  MotionBuffer() = default;
  MotionBuffer(int width, int height)
      : width_(width),
        height_(height),
        rows_(static_cast<std::size_t>(width) * 2 * sizeof(float), height) {}

  MotionView view() const {
    return {reinterpret_cast<const float*>(rows_.data()), width_, height_, rows_.stride()};
  }
  MutableMotionView view() {
    return {reinterpret_cast<float*>(rows_.data()), width_, height_, rows_.stride()};
  }
  std::size_t bytes() const { return rows_.size(); }

 private:
  int width_ = 0;
  int height_ = 0;
  RowBuffer rows_;
};

}  // namespace warplut
