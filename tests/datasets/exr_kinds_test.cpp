// The kinds of OpenEXR files that renderers and film tools write, each read rightly or refused by
// name.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

using OIIO::TypeDesc;

struct Channel {
  std::string name;
  TypeDesc type = TypeDesc::HALF;
};

// A window: its size and its corner.
struct Window {
  int width = 12, height = 10, x = 0, y = 0;
};

struct Part {
  std::vector<Channel> channels;
  std::string name = {};
  Window data = {}, display = {};
  int tile = 0;  // side; 0: scanlines
  const char* compression = "zip";
  float offset = 0;  // of its values
};

// Of a channel at a pixel of the display window's coordinates: whole numbers that a half holds.
float ValueAt(const Part& part, std::size_t channel, int x, int y) {
  return part.offset + 100.0f * static_cast<float>(channel) + static_cast<float>(x + 16 * (y % 3));
}

OIIO::ImageSpec SpecOf(const Part& part) {
  const int n = static_cast<int>(part.channels.size());
  OIIO::ImageSpec spec(part.data.width, part.data.height, n, TypeDesc::FLOAT);
  spec.x = part.data.x;
  spec.y = part.data.y;
  spec.full_x = part.display.x;
  spec.full_y = part.display.y;
  spec.full_width = part.display.width;
  spec.full_height = part.display.height;
  spec.tile_width = spec.tile_height = part.tile;
  spec.channelnames.clear();
  spec.channelformats.clear();
  for (const Channel& channel : part.channels) {
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(channel.type);
  }
  spec.attribute("compression", part.compression);
  if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
  return spec;
}

// The pixels of the data window as the file stores them, channel by channel in its own type.
std::vector<unsigned char> BytesOf(const Part& part) {
  std::vector<unsigned char> bytes;
  const auto append = [&](const auto& value) {
    const auto* p = reinterpret_cast<const unsigned char*>(&value);
    bytes.insert(bytes.end(), p, p + sizeof(value));
  };
  for (int y = 0; y < part.data.height; ++y) {
    for (int x = 0; x < part.data.width; ++x) {
      for (std::size_t c = 0; c < part.channels.size(); ++c) {
        const float v = ValueAt(part, c, x + part.data.x, y + part.data.y);
        const TypeDesc type = part.channels[c].type;
        if (type == TypeDesc::UINT32) {
          append(static_cast<std::uint32_t>(v));
        } else if (type == TypeDesc::HALF) {
          std::uint16_t half = 0;
          OIIO::convert_pixel_values(TypeDesc::FLOAT, &v, TypeDesc::HALF, &half, 1);
          append(half);
        } else {
          append(v);
        }
      }
    }
  }
  return bytes;
}

void WriteExr(const std::string& path, const std::vector<Part>& parts) {
  auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output);
  std::vector<OIIO::ImageSpec> specs;
  for (const Part& part : parts) specs.push_back(SpecOf(part));
  ASSERT_TRUE(output->open(path, static_cast<int>(specs.size()), specs.data()))
      << output->geterror();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) {
      ASSERT_TRUE(output->open(path, specs[i], OIIO::ImageOutput::AppendSubimage))
          << output->geterror();
    }
    ASSERT_TRUE(output->write_image(TypeDesc::UNKNOWN, BytesOf(parts[i]).data()))
        << output->geterror();
  }
  ASSERT_TRUE(output->close()) << output->geterror();
}

class ExrKinds : public testing::Test {
 protected:
  std::string Path() const { return folder_ / "a.exr"; }

  // That `image` has these channels of the part, by their places in it.
  static void ExpectChannels(const Image& image, const Part& part,
                             const std::vector<std::size_t>& places) {
    ASSERT_EQ(image.width, part.display.width);
    ASSERT_EQ(image.height, part.display.height);
    ASSERT_EQ(image.channels, static_cast<int>(places.size()));
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        for (std::size_t c = 0; c < places.size(); ++c) {
          ASSERT_EQ(image.at(x, y, static_cast<int>(c)),
                    ValueAt(part, places[c], x + part.display.x, y + part.display.y))
              << x << ", " << y << ", channel " << c;
        }
      }
    }
  }

  const TemporaryFolder folder_;
};

const std::vector<Channel> kRgb = {{"R"}, {"G"}, {"B"}};

TEST_F(ExrKinds, EveryTypeOfChannelIsReadAsTheNumbersThatItHolds) {
  for (const TypeDesc type : {TypeDesc::HALF, TypeDesc::FLOAT, TypeDesc::UINT32}) {
    for (const int channels : {1, 3}) {
      Part part{.channels = {{"R", type}, {"G", type}, {"B", type}}};
      part.channels.resize(static_cast<std::size_t>(channels));
      WriteExr(Path(), {part});
      ExpectChannels(
          ReadImage(Path()), part,
          channels == 1 ? std::vector<std::size_t>{0} : std::vector<std::size_t>{0, 1, 2});
      const ImageInfo info = ReadImageInfo(Path());
      EXPECT_EQ(info.integer, type == TypeDesc::UINT32);
      EXPECT_EQ(info.bits, static_cast<int>(type.basesize()) * 8);
    }
  }
}

TEST_F(ExrKinds, TypesMayBeMixed) {
  const Part part{.channels = {{"R", TypeDesc::HALF},
                               {"G", TypeDesc::FLOAT},
                               {"B", TypeDesc::HALF},
                               {"A", TypeDesc::FLOAT},
                               {"id", TypeDesc::UINT32},
                               {"Z", TypeDesc::FLOAT}}};
  WriteExr(Path(), {part});
  ExpectChannels(ReadImage(Path(), {"R", "G", "B"}), part, {0, 1, 2});
  ExpectChannels(ReadImage(Path(), {"Z", "id"}), part, {5, 4});
  ExpectChannels(ReadImage(Path(), {"id"}), part, {4});
  EXPECT_TRUE(ReadImageInfo(Path(), {"id"}).integer);
  EXPECT_EQ(ReadImageInfo(Path(), {"R"}).bits, 16);
  EXPECT_EQ(ReadImageInfo(Path(), {"Z"}).bits, 32);
  ExpectError([&] { ReadImage(Path()); }, {"6 channels", "the names of those to take"});
}

TEST_F(ExrKinds, TilesAndCompressionsAreAlike) {
  for (const int tile : {0, 8}) {
    for (const char* compression : {"none", "rle", "zip", "zips", "piz"}) {
      const Part part{.channels = kRgb, .tile = tile, .compression = compression};
      WriteExr(Path(), {part});
      ExpectChannels(ReadImage(Path()), part, {0, 1, 2});
    }
  }
}

TEST_F(ExrKinds, ColourComesInOrderWhateverItsCaseAndLayer) {
  for (const std::vector<Channel>& channels :
       {kRgb,
        std::vector<Channel>{{"r"}, {"g"}, {"b"}},
        {{"beauty.R"}, {"beauty.G"}, {"beauty.B"}},
        {{"beauty.r"}, {"beauty.g"}, {"beauty.b"}},
        {{"R"}, {"G"}, {"B"}, {"A"}},
        {{"beauty.R"}, {"beauty.G"}, {"beauty.B"}, {"beauty.A"}}}) {
    const Part part{.channels = channels};
    WriteExr(Path(), {part});
    std::vector<std::size_t> all(channels.size());
    for (std::size_t c = 0; c < all.size(); ++c) all[c] = c;
    ExpectChannels(ReadImage(Path()), part, all);
    ExpectChannels(ReadImage(Path(), {channels[2].name, channels[0].name}), part, {2, 0});
  }
}

TEST_F(ExrKinds, NamesAreTakenInAnyCaseWhereOneFits) {
  const Part part{.channels = {{"r"}, {"g"}, {"b"}, {"Beauty.R"}, {"beauty.G"}, {"BEAUTY.G"}}};
  WriteExr(Path(), {part});
  ExpectChannels(ReadImage(Path(), {"R", "G", "B"}), part, {0, 1, 2});
  ExpectChannels(ReadImage(Path(), {"beauty.r"}), part, {3});
  ExpectChannels(ReadImage(Path(), {"beauty.G"}), part, {4});
  ExpectError([&] { ReadImage(Path(), {"Beauty.g"}); }, {"no channel 'Beauty.g'", "BEAUTY.G"});
  ExpectError([&] { ReadImage(Path(), {"Z"}); }, {"no channel 'Z'"});
}

TEST_F(ExrKinds, ThreeChannelsThatAreNoColourNeedNames) {
  const Part part{.channels = {{"N.x"}, {"N.y"}, {"N.z"}}};
  WriteExr(Path(), {part});
  ExpectError([&] { ReadImage(Path()); }, {"N.x, N.y, N.z", "expected R, G, B"});
  ExpectChannels(ReadImage(Path(), {"N.x", "N.y", "N.z"}), part, {0, 1, 2});
  EXPECT_EQ(ReadImageInfo(Path()).channels.size(), 3U);
}

TEST_F(ExrKinds, OfSeveralPartsTheFirstOrTheOneThatHasTheNames) {
  const std::vector<Part> parts = {
      {.channels = kRgb, .name = "beauty"},
      {.channels = {{"Z", TypeDesc::FLOAT}}, .name = "depth", .offset = 1000},
      {.channels = {{"X", TypeDesc::FLOAT}, {"Y", TypeDesc::FLOAT}},
       .name = "motion",
       .offset = 500},
      {.channels = kRgb, .name = "diffuse", .offset = 300}};
  WriteExr(Path(), parts);
  ExpectChannels(ReadImage(Path()), parts[0], {0, 1, 2});
  ExpectChannels(ReadImage(Path(), {"R", "G", "B"}), parts[0], {0, 1, 2});
  ExpectChannels(ReadImage(Path(), {"Z"}), parts[1], {0});
  ExpectChannels(ReadImage(Path(), {"depth.Z"}), parts[1], {0});
  ExpectChannels(ReadImage(Path(), {"Y", "X"}), parts[2], {1, 0});
  ExpectChannels(ReadImage(Path(), {"diffuse.R", "diffuse.G", "diffuse.B"}), parts[3], {0, 1, 2});
  EXPECT_EQ(ReadImageInfo(Path(), {"Z"}).bits, 32);
  ExpectError([&] { ReadImage(Path(), {"R", "Z"}); }, {"no part", "R, Z"});
}

TEST_F(ExrKinds, OverscanIsCutAwayAndAWindowThatLacksPixelsIsRefused) {
  for (const TypeDesc type : {TypeDesc::HALF, TypeDesc::UINT32}) {
    const Part overscan{.channels = {{"R", type}, {"G", type}, {"B", type}},
                        .data = {20, 17, 1, 2},
                        .display = {12, 10, 4, 5}};
    WriteExr(Path(), {overscan});
    ExpectChannels(ReadImage(Path()), overscan, {0, 1, 2});
    EXPECT_EQ(ReadImageInfo(Path()).width, 12);
    EXPECT_EQ(ReadImageInfo(Path()).height, 10);
  }
  const Part moved{.channels = kRgb, .data = {12, 10, 7, 9}, .display = {12, 10, 7, 9}};
  WriteExr(Path(), {moved});
  ExpectChannels(ReadImage(Path()), moved, {0, 1, 2});
  for (const Window& data :
       {Window{11, 10, 0, 0}, Window{12, 9, 0, 1}, Window{12, 10, 1, 0}, Window{3, 3, 40, 0}}) {
    WriteExr(Path(), {{.channels = kRgb, .data = data}});
    ExpectError([&] { ReadImage(Path()); }, {"lacks a part of its display window (12 x 10"});
  }
}

}  // namespace
}  // namespace warplut
