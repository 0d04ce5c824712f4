#include "runtime/image_buffer.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace warplut {
namespace {

bool IsAligned(const void* pointer) {
  return reinterpret_cast<std::uintptr_t>(pointer) % kRowAlignment == 0;
}

TEST(RowBuffer, PadsRowsToTheAlignment) {
  for (const std::size_t row_bytes : {1, 63, 64, 65, 640}) {
    const RowBuffer rows(row_bytes, 3);
    EXPECT_TRUE(IsAligned(rows.data()));
    EXPECT_EQ(rows.stride() % static_cast<std::ptrdiff_t>(kRowAlignment), 0);
    EXPECT_GE(rows.stride(), static_cast<std::ptrdiff_t>(row_bytes));
    EXPECT_LT(rows.stride(), static_cast<std::ptrdiff_t>(row_bytes + kRowAlignment));
    EXPECT_EQ(rows.size(), 3 * static_cast<std::size_t>(rows.stride()));
  }
}

TEST(RowBuffer, BeginsAsZerosAndReturnsToThem) {
  RowBuffer rows(100, 5);
  const auto is_zero = [&] {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows.data()[i] != std::byte{0}) return false;
    }
    return true;
  };
  EXPECT_TRUE(is_zero());
  rows.data()[rows.size() - 1] = std::byte{1};
  EXPECT_FALSE(is_zero());
  rows.Clear();
  EXPECT_TRUE(is_zero());
}

TEST(RowBuffer, IsEmptyByDefault) {
  const RowBuffer rows;
  EXPECT_EQ(rows.data(), nullptr);
  EXPECT_EQ(rows.size(), 0u);
}

TEST(ImageBuffer, ViewsItsPixels) {
  for (const PixelFormat format : kPixelFormats) {
    ImageBuffer image(17, 4, format);
    const MutableImageView out = image.view();
    EXPECT_EQ(out.width, 17);
    EXPECT_EQ(out.height, 4);
    EXPECT_EQ(out.format, format);
    EXPECT_EQ(image.bytes(), static_cast<std::size_t>(out.stride) * 4);
    EXPECT_GE(out.stride, 17 * BytesPerPixel(format));
    for (int y = 0; y < 4; ++y) EXPECT_TRUE(IsAligned(out.At(0, y)));
    *static_cast<std::uint8_t*>(out.At(16, 3)) = 9;
    const ImageView in = std::as_const(image).view();
    EXPECT_EQ(*static_cast<const std::uint8_t*>(in.At(16, 3)), 9);
    image.Clear();
    EXPECT_EQ(*static_cast<const std::uint8_t*>(in.At(16, 3)), 0);
  }
}

TEST(MotionBuffer, ViewsItsVectors) {
  MotionBuffer motion(5, 3);
  motion.view().Row(2)[2 * 4 + 1] = 1.5f;
  const MotionView view = std::as_const(motion).view();
  EXPECT_EQ(view.width, 5);
  EXPECT_EQ(view.height, 3);
  EXPECT_EQ(view.Row(2)[9], 1.5f);
  EXPECT_EQ(motion.bytes(), static_cast<std::size_t>(view.stride) * 3);
  for (int y = 0; y < 3; ++y) EXPECT_TRUE(IsAligned(view.Row(y)));
}

TEST(ImageBuffer, MovesItsPixels) {
  ImageBuffer image(3, 2, PixelFormat::kRgba8);
  const void* pixels = image.view().data;
  const ImageBuffer moved = std::move(image);
  EXPECT_EQ(moved.view().data, pixels);
}

}  // namespace
}  // namespace warplut
