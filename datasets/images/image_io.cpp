#include "datasets/images/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/exr_header.h"
#include "datasets/images/flo_file.h"
#include "datasets/images/image_message.h"
#include "datasets/images/png_chunks.h"
#include "datasets/text_case.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// A part of an open file, and where in it the channels are that were asked for.
struct OpenPart {
  std::unique_ptr<OIIO::ImageInput> input;
  int part = 0;
  OIIO::ImageSpec spec;
  std::vector<int> wanted;
};

bool IsOpenExr(const OIIO::ImageInput& input) {
  return std::string_view(input.format_name()) == "openexr";
}

std::string PartName(const OIIO::ImageSpec& spec) {
  return spec.get_string_attribute("oiio:subimagename");
}

// Whether a name that was asked for is that of the channel `there` of the part.
bool IsNameOf(const std::string& name, const std::string& there, const std::string& part) {
  return name == there ||
         (!part.empty() && (name == part + "." + there || part + "." + name == there));
}

// Where the channel is among those of the part; nothing if it is not there. In any case only if
// that is clear.
std::optional<int> FindChannel(const std::string& name, const OIIO::ImageSpec& spec,
                               bool in_any_case) {
  const auto fold = [&](const std::string& text) { return in_any_case ? LowerCase(text) : text; };
  const std::string part = fold(PartName(spec));
  std::optional<int> found;
  for (int c = 0; c < spec.nchannels; ++c) {
    if (!IsNameOf(fold(name), fold(spec.channel_name(c)), part)) continue;
    if (found) return in_any_case ? std::nullopt : found;
    found = c;
  }
  return found;
}

// All of `names`, or nothing if one is not there.
std::optional<std::vector<int>> FindChannels(const std::vector<std::string>& names,
                                             const OIIO::ImageSpec& spec, bool in_any_case) {
  std::vector<int> found;
  for (const std::string& name : names) {
    const auto at = FindChannel(name, spec, in_any_case);
    if (!at) return std::nullopt;
    found.push_back(*at);
  }
  return found;
}

// The channels of a part of which none is named: R, G, B, A first, whatever their layer and case.
std::vector<int> ChannelsInOrder(const fs::path& path, const OIIO::ImageSpec& spec, bool is_exr) {
  if (spec.nchannels < 1 || spec.nchannels > 4) {
    RefuseImage(
        path, fmt::format("it has {} channels ({}); expected 1 to 4, or the names of those to take",
                          spec.nchannels, fmt::join(spec.channelnames, ", ")));
  }
  std::vector<int> order(static_cast<std::size_t>(spec.nchannels));
  std::iota(order.begin(), order.end(), 0);
  if (!is_exr || spec.nchannels < 3) return order;
  const auto rank = [&](int c) {
    constexpr std::string_view kRanks = "rgba";
    const std::string name = LowerCase(spec.channel_name(c));
    const std::string last = name.substr(name.rfind('.') + 1);
    return last.size() == 1 ? kRanks.find(last[0]) : std::string_view::npos;
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
  for (std::size_t c = 0; c < order.size(); ++c) {
    if (rank(order[c]) == c) continue;
    RefuseImage(path,
                fmt::format("its channels are {}; expected R, G, B, and A perhaps, or the names "
                            "of those to take",
                            fmt::join(spec.channelnames, ", ")));
  }
  return order;
}

void CheckSpec(const fs::path& path, const OIIO::ImageSpec& spec) {
  for (const auto& [width, height] :
       {std::pair(spec.width, spec.height), std::pair(spec.full_width, spec.full_height)}) {
    if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide) {
      RefuseImage(path, fmt::format("its size is {} x {}; expected sides from 1 to {}", width,
                                    height, kMaxImageSide));
    }
  }
  if (spec.deep || spec.depth > 1)
    RefuseImage(path, "it is deep or a volume; expected a flat image");
  if (spec.x > spec.full_x || spec.y > spec.full_y ||
      spec.x + spec.width < spec.full_x + spec.full_width ||
      spec.y + spec.height < spec.full_y + spec.full_height) {
    RefuseImage(path, fmt::format("its data window ({} x {} at {}, {}) lacks a part of its display "
                                  "window ({} x {} at {}, {}); expected all of it",
                                  spec.width, spec.height, spec.x, spec.y, spec.full_width,
                                  spec.full_height, spec.full_x, spec.full_y));
  }
}

// Deflate makes at most 1032 bytes of one, and a palette of one bit makes 32 values of each: a PNG
// file that is too short for its size is refused before memory of that size is taken.
void CheckPngLength(const fs::path& path, const OIIO::ImageInput& input) {
  constexpr std::uintmax_t kMostFromOne = 1032 * 32;
  if (std::string_view(input.format_name()) != "png") return;
  const std::uintmax_t length = fs::file_size(path), needed = input.spec().image_bytes(true);
  if (needed / kMostFromOne <= length) return;
  RefuseImage(path, fmt::format("it is {} bytes long; expected more for {} x {} pixels", length,
                                input.spec().width, input.spec().height));
}

// With `any_number` a part whose channels are not named may have any number of them, of any name.
OpenPart Open(const fs::path& path, const std::vector<std::string>& channels, bool any_number) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) RefuseImage(path, "it does not exist");
  if (!fs::is_regular_file(status)) RefuseImage(path, "it is not a regular file");

  CheckExrHeader(path);
  CheckPngChunks(path, false);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // alpha and colour as stored
  OpenPart open;
  open.input = OIIO::ImageInput::open(path.string(), &config);
  if (!open.input) RefuseImage(path, ImageMessage(OIIO::geterror()));
  const auto take = [&](int part, std::vector<int> wanted) {
    open.part = part;
    open.spec = open.input->spec(part);
    open.wanted = std::move(wanted);
    CheckSpec(path, open.spec);
  };
  CheckPngLength(path, *open.input);
  if (channels.empty()) {
    CheckSpec(path, open.input->spec());
    take(0, any_number ? std::vector<int>()
                       : ChannelsInOrder(path, open.input->spec(), IsOpenExr(*open.input)));
    return open;
  }
  std::vector<std::string> there;
  for (const bool in_any_case : {false, true}) {
    for (int part = 0; open.input->seek_subimage(part, 0); ++part) {
      const OIIO::ImageSpec spec = open.input->spec(part);
      if (auto wanted = FindChannels(channels, spec, in_any_case)) {
        take(part, std::move(*wanted));
        return open;
      }
      if (in_any_case) continue;
      for (const std::string& name : spec.channelnames) there.push_back(name);
    }
  }
  const auto missing = std::find_if(channels.begin(), channels.end(), [&](const auto& name) {
    return std::find(there.begin(), there.end(), name) == there.end();
  });
  if (missing == channels.end()) {
    RefuseImage(path, fmt::format("no part of it has all of the channels {}, only {}",
                                  fmt::join(channels, ", "), fmt::join(there, ", ")));
  }
  RefuseImage(path,
              fmt::format("it has no channel '{}', only {}", *missing, fmt::join(there, ", ")));
}

void CheckValues(const fs::path& path, const Image& image, const std::vector<int>& channels,
                 const std::vector<std::string>& names, Values accepted) {
  if (accepted == Values::kAll) return;
  const bool finite = accepted == Values::kFinite;
  const auto bad = std::find_if(image.data.begin(), image.data.end(), [&](float v) {
    return finite ? !std::isfinite(v) : std::isnan(v);
  });
  if (bad == image.data.end()) return;
  const auto i = static_cast<std::size_t>(bad - image.data.begin());
  const std::size_t n = channels.size(), pixel = i / n,
                    width = static_cast<std::size_t>(image.width);
  RefuseImage(path, fmt::format("pixel ({}, {}), channel {}, is {}; expected a {}", pixel % width,
                                pixel / width, names[static_cast<std::size_t>(channels[i % n])],
                                *bad, finite ? "finite number" : "number"));
}

// The channels at these places, in their order.
Image TakeChannels(Image image, const std::vector<int>& places) {
  bool in_order = static_cast<std::size_t>(image.channels) == places.size();
  for (std::size_t c = 0; c < places.size() && in_order; ++c) {
    in_order = places[c] == static_cast<int>(c);
  }
  if (in_order) return image;
  Image taken(image.width, image.height, static_cast<int>(places.size()));
  const auto stride = static_cast<std::size_t>(image.channels);
  for (std::size_t p = 0, to = 0; p < image.pixels(); ++p) {
    for (const int place : places) {
      taken.data[to++] = image.data[p * stride + static_cast<std::size_t>(place)];
    }
  }
  return taken;
}

const std::vector<std::string> kFloChannels = {"X", "Y"};

std::vector<int> FloChannels(const fs::path& path, const std::vector<std::string>& channels) {
  std::vector<int> wanted;
  for (const std::string& name : channels.empty() ? kFloChannels : channels) {
    const std::string upper = LowerCase(name);
    if (upper != "x" && upper != "y") {
      RefuseImage(path, fmt::format("it has no channel '{}', only X, Y", name));
    }
    wanted.push_back(upper == "x" ? 0 : 1);
  }
  return wanted;
}

// Most bytes of values that one call reads: a header that promises more than its file holds costs
// no more than that.
constexpr std::size_t kMaxBandBytes = std::size_t{1} << 24;
constexpr int kMaxBandRows = 256;  // as many as the tallest blocks of lines that OpenEXR has

// Rows that are read at once, of which each has `row_bytes`; whole tiles.
int BandRows(const OIIO::ImageSpec& spec, std::size_t row_bytes) {
  const auto fit = static_cast<int>(std::min<std::size_t>(kMaxBandRows, kMaxBandBytes / row_bytes));
  const int least = std::max(1, spec.tile_width > 0 ? spec.tile_height : 1);
  return std::max(least, fit / least * least);
}

// The channels from `begin` to `end` of `rows` rows from row `y` of the data window.
bool ReadRows(const OpenPart& open, int y, int rows, int begin, int end, const OIIO::TypeDesc& type,
              void* values) {
  const OIIO::ImageSpec& spec = open.spec;
  const int first = spec.y + y;
  if (spec.tile_width == 0) {
    return open.input->read_scanlines(open.part, 0, first, first + rows, spec.z, begin, end, type,
                                      values);
  }
  return open.input->read_tiles(open.part, 0, spec.x, spec.x + spec.width, first, first + rows,
                                spec.z, spec.z + 1, begin, end, type, values);
}

// The wanted channels of the data window, in memory that grows with what was read. Integers of
// OpenEXR are numbers, not shares of the largest.
Image ReadPart(const fs::path& path, const OpenPart& open) {
  CheckPngChunks(path, true);
  const OIIO::ImageSpec& spec = open.spec;
  const bool is_exr = IsOpenExr(*open.input);
  const auto is_number = [&](int c) {
    return is_exr && spec.channelformat(c) == OIIO::TypeDesc::UINT32;
  };
  const bool numbers = std::any_of(open.wanted.begin(), open.wanted.end(), is_number);
  const auto [low, high] = std::minmax_element(open.wanted.begin(), open.wanted.end());
  const auto width = static_cast<std::size_t>(spec.width), channels = open.wanted.size();
  const std::size_t stride = numbers ? 1 : static_cast<std::size_t>(*high + 1 - *low);
  const int band = BandRows(spec, sizeof(float) * width * stride);
  Image image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = static_cast<int>(channels);
  std::vector<float> values;
  std::vector<std::uint32_t> integers;
  for (int y = 0; y < spec.height; y += band) {
    const int rows = std::min(band, spec.height - y);
    const std::size_t pixels = width * static_cast<std::size_t>(rows), done = image.data.size();
    const auto check = [&](bool ok) {
      // A reader that fills what is missing still leaves a message.
      if (!ok || open.input->has_error()) RefuseImage(path, ImageMessage(open.input->geterror()));
    };
    values.resize(pixels * stride);
    if (!numbers) {
      check(ReadRows(open, y, rows, *low, *high + 1, OIIO::TypeDesc::FLOAT, values.data()));
    }
    image.data.resize(done + pixels * channels);
    for (std::size_t c = 0; c < channels; ++c) {
      const int channel = open.wanted[c];
      if (numbers && is_number(channel)) {
        integers.resize(pixels);
        check(
            ReadRows(open, y, rows, channel, channel + 1, OIIO::TypeDesc::UINT32, integers.data()));
        std::transform(integers.begin(), integers.end(), values.begin(),
                       [](std::uint32_t v) { return static_cast<float>(v); });
      } else if (numbers) {
        check(ReadRows(open, y, rows, channel, channel + 1, OIIO::TypeDesc::FLOAT, values.data()));
      }
      const std::size_t place = numbers ? 0 : static_cast<std::size_t>(channel - *low);
      for (std::size_t p = 0; p < pixels; ++p) {
        image.data[done + p * channels + c] = values[p * stride + place];
      }
    }
  }
  return image;
}

// The display window of an image of the data window, which holds it.
Image DisplayWindow(Image data, const OIIO::ImageSpec& spec) {
  if (spec.width == spec.full_width && spec.height == spec.full_height) return data;
  Image window(spec.full_width, spec.full_height, data.channels);
  const std::size_t row = static_cast<std::size_t>(window.width) * window.channels;
  for (int y = 0; y < window.height; ++y) {
    std::copy_n(&data.data[data.Index(spec.full_x - spec.x, spec.full_y - spec.y + y)], row,
                &window.data[window.Index(0, y)]);
  }
  return window;
}

}  // namespace

std::vector<ImagePart> ReadImageParts(const fs::path& path) {
  if (HasExtension(path, ".flo")) {
    const ImageInfo info = ReadFloInfo(path);
    return {{"", info.width, info.height, info.channels, {"float", "float"}}};
  }
  std::error_code ignored;
  if (!fs::exists(path, ignored)) RefuseImage(path, "it does not exist");
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) RefuseImage(path, ImageMessage(OIIO::geterror()));
  std::vector<ImagePart> parts;
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    const OIIO::ImageSpec spec = input->spec(part);
    ImagePart& out = parts.emplace_back(
        ImagePart{PartName(spec), spec.full_width, spec.full_height, spec.channelnames, {}});
    for (int c = 0; c < spec.nchannels; ++c) out.types.emplace_back(spec.channelformat(c).c_str());
  }
  return parts;
}

ImageInfo ReadImageInfo(const fs::path& path, const std::vector<std::string>& channels) {
  if (HasExtension(path, ".flo")) return ReadFloInfo(path);
  const OpenPart open = Open(path, channels, true);
  const OIIO::TypeDesc type = open.spec.channelformat(channels.empty() ? 0 : open.wanted.front());
  return {open.spec.full_width, open.spec.full_height, open.spec.channelnames,
          static_cast<int>(type.basesize()) * 8, !type.is_floating_point()};
}

Image ReadImage(const fs::path& path, const std::vector<std::string>& channels, Values accepted) {
  if (HasExtension(path, ".flo")) {
    const std::vector<int> wanted = FloChannels(path, channels);
    Image image = TakeChannels(ReadFlo(path), wanted);
    CheckValues(path, image, wanted, kFloChannels, accepted);
    return image;
  }
  const OpenPart open = Open(path, channels, false);
  Image image;
  try {
    image = DisplayWindow(ReadPart(path, open), open.spec);
  } catch (const std::bad_alloc&) {
    RefuseImage(path, fmt::format("there is no memory for {} x {} pixels", open.spec.width,
                                  open.spec.height));
  }
  CheckValues(path, image, open.wanted, open.spec.channelnames, accepted);
  return image;
}

}  // namespace warplut
