#include "train/replay/image_views.h"

#include <tbb/parallel_for.h>

#include <cstring>

#include "runtime/core/pixel.h"

namespace warplut {
ImageBuffer ToBuffer(const Image& image, PixelFormat format) {
  ImageBuffer buffer(image.width, image.height, format);
  const MutableImageView view = buffer.view();
  const float scale = ChannelScale(format);
  const int channels = Channels(format);
  tbb::parallel_for(0, image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      void* pixel = view.At(x, y);
      for (int c = 0; c < channels; ++c) {
        StoreChannel(format, scale * (c < image.channels ? image.at(x, y, c) : 1.0f), pixel, c);
      }
    }
  });
  return buffer;
}

MotionBuffer ToMotionBuffer(const Image& motion) {
  MotionBuffer buffer(motion.width, motion.height);
  const MutableMotionView view = buffer.view();
  const std::size_t row = 2 * sizeof(float) * static_cast<std::size_t>(motion.width);
  for (int y = 0; y < motion.height; ++y) {
    std::memcpy(view.Row(y), &motion.data[motion.Index(0, y)], row);
  }
  return buffer;
}

Image ToImage(const ImageView& view) {
  Image image(view.width, view.height, view.format == PixelFormat::kR32F ? 1 : 3);
  const float scale = ChannelScale(view.format);
  tbb::parallel_for(0, image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const void* pixel = view.At(x, y);
      for (int c = 0; c < image.channels; ++c) {
        image.at(x, y, c) = LoadChannel(view.format, pixel, c) / scale;
      }
    }
  });
  return image;
}

Image ToImage(const MotionView& view) {
  Image image(view.width, view.height, 2);
  const std::size_t row = 2 * sizeof(float) * static_cast<std::size_t>(view.width);
  for (int y = 0; y < view.height; ++y) {
    std::memcpy(&image.data[image.Index(0, y)], view.Row(y), row);
  }
  return image;
}

void CopyPixels(const ImageView& from, const MutableImageView& to) {
  const std::size_t row =
      static_cast<std::size_t>(from.width) * static_cast<std::size_t>(BytesPerPixel(from.format));
  for (int y = 0; y < from.height; ++y) {
    std::memcpy(to.Row<std::byte>(y), from.Row<std::byte>(y), row);
  }
}

void CopyMotion(const MotionView& from, const MutableMotionView& to) {
  const std::size_t row = 2 * sizeof(float) * static_cast<std::size_t>(from.width);
  for (int y = 0; y < from.height; ++y) std::memcpy(to.Row(y), from.Row(y), row);
}

}  // namespace warplut
