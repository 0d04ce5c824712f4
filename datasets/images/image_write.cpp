// Image files written, through OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/images/image_message.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailWrite(const fs::path& path, const std::string& reason) {
  throw Error(fmt::format("cannot write the image '{}': {}", path.string(), reason));
}

OIIO::TypeDesc OiioType(PixelType type) {
  switch (type) {
    case PixelType::kUint8:
      return OIIO::TypeDesc::UINT8;
    case PixelType::kUint16:
      return OIIO::TypeDesc::UINT16;
    case PixelType::kHalf:
      return OIIO::TypeDesc::HALF;
    case PixelType::kFloat:
      return OIIO::TypeDesc::FLOAT;
  }
  return OIIO::TypeDesc::UNKNOWN;
}

// The image as integers from 0 to the largest T.
template <class T>
std::vector<T> Quantize(const fs::path& path, const Image& image) {
  constexpr double kMax = std::numeric_limits<T>::max();
  std::vector<T> values(image.data.size());
  std::transform(image.data.begin(), image.data.end(), values.begin(), [&](float v) {
    if (std::isnan(v)) FailWrite(path, "it has a NaN, which an integer file cannot hold");
    return static_cast<T>(std::floor(std::clamp(double{v}, 0.0, 1.0) * kMax + 0.5));
  });
  return values;
}

void CheckHalf(const fs::path& path, const Image& image) {
  constexpr float kOverflow = 65520;  // rounds to the half that would be 65536
  for (const float v : image.data) {
    if (std::isfinite(v) && std::abs(v) >= kOverflow) {
      FailWrite(path,
                fmt::format("it has the value {}; expected at most 65504, the largest half", v));
    }
  }
}

OIIO::ImageSpec OutputSpec(const Image& image, PixelType type,
                           const std::vector<std::string>& names) {
  static const std::vector<std::string> kDefaultNames[] = {
      {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OiioType(type));
  spec.channelnames = names.empty() ? kDefaultNames[image.channels - 1] : names;
  spec.alpha_channel = -1;
  for (int c = 0; c < image.channels; ++c) {
    if (spec.channel_name(c) == "A") spec.alpha_channel = c;
  }
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // else the time of writing
  return spec;
}

// The bytes of the file: encoded in memory, so that every write to the disk is checked in one
// place.
std::vector<unsigned char> Encode(const fs::path& path, const Image& image, PixelType type,
                                  const std::vector<std::string>& names) {
  std::vector<unsigned char> bytes;
  // Outlives the writer, which at its end closes what it has open.
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create(path.string());
  if (!output) FailWrite(path, ImageMessage(OIIO::geterror()));
  if (!output->set_ioproxy(&memory)) FailWrite(path, "its format cannot be encoded in memory");
  const auto check = [&](bool ok) {
    if (!ok) FailWrite(path, ImageMessage(output->geterror()));
  };
  check(output->open(path.string(), OutputSpec(image, type, names)));
  if (type == PixelType::kUint8) {
    check(output->write_image(OIIO::TypeDesc::UINT8, Quantize<std::uint8_t>(path, image).data()));
  } else if (type == PixelType::kUint16) {
    check(output->write_image(OIIO::TypeDesc::UINT16, Quantize<std::uint16_t>(path, image).data()));
  } else {
    if (type == PixelType::kHalf) CheckHalf(path, image);
    check(output->write_image(OIIO::TypeDesc::FLOAT, image.data.data()));
  }
  check(output->close());
  return bytes;
}

}  // namespace

void WriteImage(const fs::path& path, const Image& image, PixelType type,
                const std::vector<std::string>& channel_names) {
  if (image.empty() || image.channels > 4) {
    FailWrite(path,
              fmt::format("it is {} x {} with {} channels; expected pixels and 1 to 4 channels",
                          image.width, image.height, image.channels));
  }
  if (!channel_names.empty() && channel_names.size() != static_cast<std::size_t>(image.channels)) {
    FailWrite(path, fmt::format("{} channels have {} names", image.channels, channel_names.size()));
  }
  const bool integer = type == PixelType::kUint8 || type == PixelType::kUint16;
  if (path.extension() != (integer ? ".png" : ".exr")) {
    FailWrite(path, integer ? "expected the extension .png for 8 and 16 bits"
                            : "expected the extension .exr for half and float");
  }
  const std::vector<unsigned char> bytes = Encode(path, image, type, channel_names);
  WriteFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace warplut
