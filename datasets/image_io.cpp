#include "datasets/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include "datasets/error.h"
#include "datasets/file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailRead(const fs::path& path, const std::string& reason) {
  throw Error(fmt::format("cannot read the image '{}': {}", path.string(), reason));
}

[[noreturn]] void FailWrite(const fs::path& path, const std::string& reason) {
  throw Error(fmt::format("cannot write the image '{}': {}", path.string(), reason));
}

std::string OneLine(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return message.empty() ? "it is damaged or of an unknown format" : message;
}

std::unique_ptr<OIIO::ImageInput> Open(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) FailRead(path, "it does not exist");
  if (!fs::is_regular_file(status)) FailRead(path, "it is not a regular file");

  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // alpha and colour as stored
  auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) FailRead(path, OneLine(OIIO::geterror()));

  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kMaxImageSide ||
      spec.height > kMaxImageSide) {
    FailRead(path, fmt::format("its size is {} x {}; expected sides from 1 to {}", spec.width,
                               spec.height, kMaxImageSide));
  }
  if (spec.deep || spec.depth > 1) FailRead(path, "it is deep or a volume; expected a flat image");
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
      spec.height != spec.full_height) {
    FailRead(path, fmt::format("its data window ({} x {} at {}, {}) is not its display window "
                               "({} x {} at {}, {}); expected both alike",
                               spec.width, spec.height, spec.x, spec.y, spec.full_width,
                               spec.full_height, spec.full_x, spec.full_y));
  }
  return input;
}

// Where each asked channel is in the file.
std::vector<int> FindChannels(const fs::path& path, const OIIO::ImageSpec& spec,
                              const std::vector<std::string>& names) {
  std::vector<int> found;
  if (names.empty()) {
    if (spec.nchannels < 1 || spec.nchannels > 4) {
      FailRead(path, fmt::format(
                         "it has {} channels ({}); expected 1 to 4, or the names of those to take",
                         spec.nchannels, fmt::join(spec.channelnames, ", ")));
    }
    for (int c = 0; c < spec.nchannels; ++c) found.push_back(c);
    return found;
  }
  for (const std::string& name : names) {
    const auto at = std::find(spec.channelnames.begin(), spec.channelnames.end(), name);
    if (at == spec.channelnames.end()) {
      FailRead(path, fmt::format("it has no channel '{}', only {}", name,
                                 fmt::join(spec.channelnames, ", ")));
    }
    found.push_back(static_cast<int>(at - spec.channelnames.begin()));
  }
  return found;
}

void CheckValues(const fs::path& path, const Image& image, const std::vector<int>& channels,
                 const OIIO::ImageSpec& spec, Values accepted) {
  if (accepted == Values::kAll) return;
  const bool finite = accepted == Values::kFinite;
  const auto bad = std::find_if(image.data.begin(), image.data.end(), [&](float v) {
    return finite ? !std::isfinite(v) : std::isnan(v);
  });
  if (bad == image.data.end()) return;
  const auto i = static_cast<std::size_t>(bad - image.data.begin());
  const std::size_t n = channels.size(), pixel = i / n,
                    width = static_cast<std::size_t>(image.width);
  FailRead(path, fmt::format("pixel ({}, {}), channel {}, is {}; expected a {}", pixel % width,
                             pixel / width, spec.channel_name(channels[i % n]), *bad,
                             finite ? "finite number" : "number"));
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

// The bytes of the file: encoded in memory, so that every write to the disk is checked in one place.
std::vector<unsigned char> Encode(const fs::path& path, const Image& image, PixelType type,
                                  const std::vector<std::string>& names) {
  std::vector<unsigned char> bytes;
  // Outlives the writer, which at its end closes what it has open.
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create(path.string());
  if (!output) FailWrite(path, OneLine(OIIO::geterror()));
  if (!output->set_ioproxy(&memory)) FailWrite(path, "its format cannot be encoded in memory");
  const auto check = [&](bool ok) {
    if (!ok) FailWrite(path, OneLine(output->geterror()));
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

ImageInfo ReadImageInfo(const fs::path& path) {
  const auto input = Open(path);
  const OIIO::ImageSpec& spec = input->spec();
  const OIIO::TypeDesc type = spec.channelformat(0);
  return {spec.width, spec.height, spec.channelnames, static_cast<int>(type.basesize()) * 8,
          !type.is_floating_point()};
}

Image ReadImage(const fs::path& path, const std::vector<std::string>& channels, Values accepted) {
  const auto input = Open(path);
  const OIIO::ImageSpec spec = input->spec();
  const std::vector<int> wanted = FindChannels(path, spec, channels);
  const auto [low, high] = std::minmax_element(wanted.begin(), wanted.end());
  const int begin = *low, end = *high + 1;

  Image image;
  try {
    Image read(spec.width, spec.height, end - begin);
    if (!input->read_image(0, 0, begin, end, OIIO::TypeDesc::FLOAT, read.data.data())) {
      FailRead(path, OneLine(input->geterror()));
    }
    // A reader that fills what is missing still leaves a message.
    if (input->has_error()) FailRead(path, OneLine(input->geterror()));
    const auto n = static_cast<int>(wanted.size());
    bool in_order = read.channels == n;
    for (int c = 0; c < n && in_order; ++c)
      in_order = wanted[static_cast<std::size_t>(c)] == begin + c;
    if (in_order) {
      image = std::move(read);
    } else {
      image = Image(spec.width, spec.height, n);
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          for (int c = 0; c < n; ++c) {
            image.at(x, y, c) = read.at(x, y, wanted[static_cast<std::size_t>(c)] - begin);
          }
        }
      }
    }
  } catch (const std::bad_alloc&) {
    FailRead(path, fmt::format("there is no memory for {} x {} pixels", spec.width, spec.height));
  }
  CheckValues(path, image, wanted, spec, accepted);
  return image;
}

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
