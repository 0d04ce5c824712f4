#include "runtime/core/image_check.h"

namespace warplut {
namespace {

bool CheckSize(std::string_view name, const void* data, int width, int height, int expected_width,
               int expected_height, std::string* why) {
  if (data == nullptr) return Refuse({name, " has no data."}, why);
  if (width == expected_width && height == expected_height) return true;
  return Refuse({name, " is ", SizeName(width, height), "; expected ",
                 SizeName(expected_width, expected_height), "."},
                why);
}

// Rows of `row` bytes at least, of whole elements of `element` bytes.
bool CheckStride(std::string_view name, std::ptrdiff_t stride, std::ptrdiff_t row,
                 std::ptrdiff_t element, const char* elements, std::string* why) {
  if (stride >= row && stride % element == 0) return true;
  return Refuse({name, " has a stride of ", std::to_string(stride),
                 " bytes; expected at least a row of whole ", elements, "."},
                why);
}

bool CheckImage(const char* name, const ImageView& image, int width, int height, bool is_depth,
                std::string* why) {
  if (!CheckSize(name, image.data, image.width, image.height, width, height, why)) return false;
  if ((image.format == PixelFormat::kR32F) != is_depth) {
    return Refuse({name, " has the format ", Name(image.format), "; expected ",
                   is_depth ? "r32f." : "rgba8, rgba16f or rgba32f."},
                  why);
  }
  const std::ptrdiff_t pixel = BytesPerPixel(image.format);
  return CheckStride(name, image.stride, width * pixel, pixel / Channels(image.format), "channels",
                     why);
}

}  // namespace

bool Refuse(std::initializer_list<std::string_view> sentence, std::string* why) {
  if (why == nullptr) return false;
  why->clear();
  for (const std::string_view part : sentence) why->append(part);
  return false;
}

std::string SizeName(int width, int height) {
  std::string size = std::to_string(width);
  size += " x ";
  size += std::to_string(height);
  return size;
}

bool CheckColor(const char* name, const ImageView& image, int width, int height, std::string* why) {
  return CheckImage(name, image, width, height, false, why);
}

bool CheckDepth(const char* name, const ImageView& image, int width, int height, std::string* why) {
  return CheckImage(name, image, width, height, true, why);
}

bool CheckMotion(const char* name, const MotionView& motion, int width, int height,
                 std::string* why) {
  constexpr auto kFloat = static_cast<std::ptrdiff_t>(sizeof(float));
  return CheckSize(name, motion.xy, motion.width, motion.height, width, height, why) &&
         CheckStride(name, motion.stride, 2 * kFloat * width, kFloat, "floats", why);
}

}  // namespace warplut
