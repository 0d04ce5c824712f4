// Reactive masks, HUDs and render sizes that vary: fields of version 2 of a manifest.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/sequence_writer.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/train/replay/pan_sequence.h"

namespace warplut {
namespace {

constexpr Streams kMasks = Streams::kReactive | Streams::kHud;

PanOptions Options() { return {.frames = 2, .streams = Streams::kAll | kMasks, .spot = true}; }

class MaskStream : public testing::Test {
 protected:
  Sequence Write(const PanOptions& options = Options()) const {
    return WritePan(folder_ / "pan", options);
  }

  // The manifest with its text changed.
  Sequence Rewritten(const std::string& from, const std::string& to) const {
    const auto manifest = folder_ / "pan" / Sequence::kManifest;
    std::string text = ReadFile(manifest);
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from << " in " << text;
    if (place == std::string::npos) return {};
    text.replace(place, from.size(), to);
    WriteFile(folder_ / "pan" / "other.json", text);
    return ReadSequence(folder_ / "pan" / "other.json");
  }

  const TemporaryFolder folder_;
};

TEST_F(MaskStream, IsReadAsItWasWritten) {
  for (const ColorSpace space : {ColorSpace::kSrgb, ColorSpace::kLinear}) {
    const TemporaryFolder folder;
    PanOptions options = Options();
    options.color_space = space;
    const Sequence s = WritePan(folder / "pan", options);
    EXPECT_TRUE(s.UsesVersion2());
    EXPECT_EQ(SequenceJson(s), ReadFile(folder / "pan" / Sequence::kManifest));
    EXPECT_EQ(StreamNames(AvailableStreams(s) & kMasks),
              (std::vector<std::string>{"reactive", "hud"}));
    const Frame frame = LoadFrame(s, 1, kMasks);
    const Frame written = Pan(options).At(1, {});
    EXPECT_EQ(frame.reactive.channels, 1);
    EXPECT_EQ(*std::max_element(frame.reactive.data.begin(), frame.reactive.data.end()), 1);
    EXPECT_EQ(*std::min_element(frame.reactive.data.begin(), frame.reactive.data.end()), 0);
    EXPECT_EQ(frame.hud.channels, 4);
    for (std::size_t i = 0; i < frame.hud.data.size(); ++i) {
      ASSERT_NEAR(frame.hud.data[i], written.hud.data[i], 0.51 / 255) << i;
    }
    EXPECT_EQ(FrameFiles(s, 0, kMasks).size(), 2U);
  }
}

TEST_F(MaskStream, WithoutOneTheManifestIsOfVersion1) {
  const Sequence s = Write({.frames = 1});
  EXPECT_FALSE(s.UsesVersion2());
  EXPECT_EQ(AvailableStreams(s), Streams::kAll);
  ExpectError([&] { LoadFrame(s, 0, Streams::kReactive); }, {"'reactive'", "it has: color"});
}

TEST_F(MaskStream, StraightAlphaBecomesPremultiplied) {
  Write();
  const Sequence straight = Rewritten("\"premultiplied\"", "\"straight\"");
  Image stored(80, 64, 4);
  for (std::size_t i = 0; i < stored.data.size(); ++i) stored.data[i] = i % 4 == 3 ? 0.6F : 0.4F;
  WriteImage(FrameFiles(straight, 0, Streams::kHud).front(), stored, PixelType::kUint8);
  const Image hud = LoadFrame(straight, 0, Streams::kHud).hud;
  EXPECT_NEAR(hud.at(5, 5, 0), 0.24, 1e-6);
  EXPECT_NEAR(hud.at(5, 5, 3), 0.6, 1e-6);
  // And back, by a writer.
  const SequenceWriter writer(folder_ / "straight", straight);
  for (int i = 0; i < 2; ++i) writer.Write(i, LoadFrame(straight, i, AvailableStreams(straight)));
  writer.Finish();
  const Image again = LoadFrame(ReadSequence(folder_ / "straight"), 0, Streams::kHud).hud;
  EXPECT_EQ(again.data, hud.data);
}

TEST_F(MaskStream, AlphaMultipliesStraightColourWhereBothAreRead) {
  Write({.frames = 1, .streams = Streams::kAll});
  const auto with = [&](const std::string& alpha) {
    std::string text = ReadFile(folder_ / "pan" / Sequence::kManifest);
    const std::string version = "\"version\": 1", color = "\"color\": {";
    text.replace(text.find(version), version.size(), "\"version\": 2");
    WriteFile(folder_ / "pan" / "other.json", text.insert(text.find(color), alpha));
    return ReadSequence(folder_ / "pan" / "other.json");
  };
  const std::string stream =
      R"("alpha": {"path": "lr/both/%04d.png", "grid": "render", "channels": ["A"], )"
      R"("color": "straight"}, )";
  const Sequence s = with(stream);
  EXPECT_TRUE(s.UsesVersion2());
  WriteFile(folder_ / "pan" / "again.json", SequenceJson(s));
  const Sequence again = ReadSequence(folder_ / "pan" / "again.json");
  EXPECT_EQ(again.alpha->channels, std::vector<std::string>{"A"});
  EXPECT_EQ(again.alpha->color, AlphaKind::kStraight);
  std::filesystem::create_directories(folder_ / "pan" / "lr/both");
  Image stored(40, 32, 4);
  for (std::size_t i = 0; i < stored.data.size(); ++i) stored.data[i] = i % 4 == 3 ? 0.6F : 0.4F;
  WriteImage(FrameFiles(s, 0, Streams::kAlpha).front(), stored, PixelType::kUint8);
  const Frame plain = LoadFrame(s, 0, Streams::kColor);
  const Frame both = LoadFrame(s, 0, Streams::kColor | Streams::kAlpha);
  EXPECT_TRUE(plain.alpha.empty());
  EXPECT_EQ(both.alpha.channels, 1);
  EXPECT_NEAR(both.alpha.at(3, 4), 0.6, 1e-6);
  EXPECT_NEAR(both.color.at(3, 4, 1), 0.6 * plain.color.at(3, 4, 1), 1e-6);

  ExpectError([&] { with(R"("reference_alpha": {"path": "%d.png", "grid": "output"}, )"); },
              {"reference_alpha", "color"});
  ExpectError(
      [&] { with(R"("alpha": {"path": "%d.png", "grid": "output", "color": "straight"}, )"); },
      {"alpha.grid", "render"});
  ExpectError(
      [&] {
        with(stream + R"("hud": {"path": "%d.png", "grid": "output", "alpha": "straight"}, )");
      },
      {"streams.hud", "beside an alpha"});
  ExpectError([&] { SequenceWriter(folder_ / "other", s); }, {"lr/both", "straight"});
}

TEST_F(MaskStream, BadFilesAreRefusedInOneSentence) {
  const Sequence s = Write();
  const auto mask = FrameFiles(s, 0, Streams::kReactive).front();
  const auto hud = FrameFiles(s, 0, Streams::kHud).front();
  const auto load = [&](Streams stream) { return [&s, stream] { LoadFrame(s, 0, stream); }; };
  WriteImage(mask, Image(39, 32, 1), PixelType::kUint8);
  ExpectError(load(Streams::kReactive), {mask.string(), "39 x 32", "40 x 32"});
  WriteImage(mask, Image(40, 32, 3), PixelType::kUint8);
  ExpectError(load(Streams::kReactive), {mask.string(), "3 channels", "expected 1"});
  WriteImage(hud, Image(80, 64, 3), PixelType::kUint8);
  ExpectError(load(Streams::kHud), {hud.string(), "3 channels", "expected 4"});
  for (const auto& file : {mask, hud}) std::filesystem::remove(file);
  ExpectError(load(Streams::kReactive), {mask.string()});
  ExpectError(load(Streams::kHud), {hud.string()});
}

TEST_F(MaskStream, ValuesOutsideOfTheRangeAreRefused) {
  PanOptions options = Options();
  options.color_space = ColorSpace::kLinear;
  Write(options);
  const Sequence s = Rewritten("lr/reactive/%04d.png", "lr/reactive/%04d.exr");
  const auto mask = FrameFiles(s, 0, Streams::kReactive).front();
  const auto hud = FrameFiles(s, 0, Streams::kHud).front();
  Image wrong(40, 32, 1), layer(80, 64, 4);
  wrong.at(3, 2) = 1.25F;
  WriteImage(mask, wrong, PixelType::kFloat);
  ExpectError([&] { LoadFrame(s, 0, Streams::kReactive); },
              {mask.string(), "pixel (3, 2) has the mask value 1.25; expected 0 to 1"});
  wrong.at(3, 2) = std::nanf("");
  WriteImage(mask, wrong, PixelType::kFloat);
  ExpectError([&] { LoadFrame(s, 0, Streams::kReactive); }, {mask.string(), "(3, 2)"});
  layer.at(4, 5, 3) = -0.5F;
  WriteImage(hud, layer, PixelType::kFloat);
  ExpectError([&] { LoadFrame(s, 0, Streams::kHud); },
              {hud.string(), "pixel (4, 5) has the alpha -0.5; expected 0 to 1"});
  layer.at(4, 5, 3) = 1;
  layer.at(4, 5, 0) = 9;  // light that a linear HUD may give
  WriteImage(hud, layer, PixelType::kFloat);
  EXPECT_EQ(LoadFrame(s, 0, Streams::kHud).hud.at(4, 5, 0), 9);
}

TEST_F(MaskStream, FieldsAreChecked) {
  Write();
  ExpectError([&] { Rewritten("\"alpha\":\"premultiplied\"", "\"alpha\":\"none\""); },
              {"streams.hud.alpha", "none", "straight"});
  ExpectError([&] { Rewritten(",\"alpha\":\"premultiplied\"", ""); }, {"streams.hud", "alpha"});
  ExpectError([&] { Rewritten("\"version\": 2", "\"version\": 1"); }, {"version", "expected 2"});
  ExpectError(
      [&] {
        Rewritten("\"lr/reactive/%04d.png\",\"grid\":\"render\"",
                  "\"lr/reactive/%04d.png\",\"grid\":\"output\"");
      },
      {"streams.reactive.grid", "output", "render"});
}

TEST_F(MaskStream, RenderSizesVaryFromFrameToFrame) {
  PanOptions options = Options();
  options.frames = 3;
  options.render_sizes = {{40, 32}, {30, 20}, {40, 32}};
  const Sequence s = Write(options);
  EXPECT_TRUE(s.UsesVersion2());
  EXPECT_EQ(SequenceJson(s), ReadFile(folder_ / "pan" / Sequence::kManifest));
  const Frame frame = LoadFrame(s, 1, AvailableStreams(s));
  for (const Image* image : {&frame.color, &frame.depth, &frame.motion, &frame.reactive}) {
    EXPECT_EQ(image->width, 30);
    EXPECT_EQ(image->height, 20);
  }
  EXPECT_EQ(frame.reference.width, 80);
  const std::string field = "\"render_sizes\": ";
  const std::string sizes = "[[40,32],[30,20],[40,32]]";
  ExpectError([&] { Rewritten(sizes, "[[40,32],[30,20]]"); }, {"render_sizes", "2 values", "3"});
  ExpectError([&] { Rewritten(sizes, "[[40,32],[41,20],[40,32]]"); },
              {"render_sizes[1]", "41 x 20", "40 x 32"});
  ExpectError([&] { Rewritten(sizes, "[[40,32],[40,15],[40,32]]"); },
              {"render_sizes[1]", "40 x 15"});
  ExpectError([&] { Rewritten(sizes, "[]"); }, {"render_sizes", "no values"});
  const Sequence other = Rewritten(sizes, "[[40,32],[31,20],[40,32]]");
  ExpectError([&] { LoadFrame(other, 1, Streams::kColor); }, {"30 x 20; expected 31 x 20"});
}

TEST_F(MaskStream, FramesAreBroughtToTheExposureOfTheFirst) {
  PanOptions options = Options();
  options.color_space = ColorSpace::kLinear;
  Sequence s = Write(options);
  const Streams colors = Streams::kColor | Streams::kReference;
  const Frame first = LoadFrame(s, 0, colors), stored = LoadFrame(s, 1, colors);
  s.exposures = {0.5, 2};
  EXPECT_TRUE(s.UsesVersion2());
  WriteFile(folder_ / "pan" / "exposed.json", SequenceJson(s));
  const Sequence exposed = ReadSequence(folder_ / "pan" / "exposed.json");
  EXPECT_EQ(exposed.exposures, s.exposures);
  EXPECT_EQ(LoadFrame(exposed, 0, colors).color.data, first.color.data);
  const Frame frame = LoadFrame(exposed, 1, colors | Streams::kHud);
  for (const auto& [read, file] :
       {std::pair(&frame.color, &stored.color), std::pair(&frame.reference, &stored.reference)}) {
    for (std::size_t i = 0; i < read->data.size(); ++i) {
      ASSERT_EQ(read->data[i], file->data[i] / 4) << i;
    }
  }
  EXPECT_EQ(frame.hud.data, LoadFrame(s, 1, Streams::kHud).hud.data);
}

TEST_F(MaskStream, ExposuresAreChecked) {
  PanOptions options = Options();
  options.color_space = ColorSpace::kLinear;
  const Sequence s = Write(options);
  const auto refused = [&](const std::vector<double>& exposures, ColorSpace space,
                           const std::string& piece) {
    Sequence other = s;
    other.exposures = exposures;
    other.color_space = space;
    std::string why;
    EXPECT_FALSE(other.IsValid(&why));
    EXPECT_NE(why.find("exposures"), std::string::npos) << why;
    EXPECT_NE(why.find(piece), std::string::npos) << why;
  };
  refused({1}, ColorSpace::kLinear, "has 1 values; expected one for each of the 2 frames");
  refused({1, 0}, ColorSpace::kLinear, "exposures[1]' is 0; expected 1 / 1048576 to 1048576");
  refused({-1, 1}, ColorSpace::kLinear, "is -1");
  refused({1, 2e6}, ColorSpace::kLinear, "is 2000000");
  refused({1, 1}, ColorSpace::kSrgb, "expected linear colour");
  const std::string field = "\"color_space\": \"linear\"";
  ExpectError([&] { Rewritten(field, field + ", \"exposures\": []"); }, {"exposures", "no values"});
  ExpectError([&] { Rewritten(field, field + ", \"exposures\": [1, \"2\"]"); },
              {"exposures[1]", "expected a number"});
}

}  // namespace
}  // namespace warplut
