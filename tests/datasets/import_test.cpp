// Each preset reads a small file in its format to known values.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/import/dpt_file.h"
#include "datasets/import/import_sequence.h"
#include "datasets/import/numbered_files.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr int kWidth = 8, kHeight = 4;

// An OpenEXR file of constant float channels.
void WriteChannels(const std::filesystem::path& path,
                   const std::vector<std::pair<std::string, float>>& channels) {
  std::filesystem::create_directories(path.parent_path());
  const auto count = static_cast<int>(channels.size());
  OIIO::ImageSpec spec(kWidth, kHeight, count, OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  std::vector<float> data;
  for (const auto& [name, value] : channels) spec.channelnames.push_back(name);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    for (const auto& [name, value] : channels) data.push_back(value);
  }
  auto file = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(file && file->open(path.string(), spec));
  ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, data.data()));
  file->close();
}

Image Constant(const std::vector<float>& values) {
  Image image(kWidth, kHeight, static_cast<int>(values.size()));
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = values[i % values.size()];
  return image;
}

void WriteConstant(const std::filesystem::path& path, const std::vector<float>& values,
                   PixelType type, const std::vector<std::string>& names = {}) {
  std::filesystem::create_directories(path.parent_path());
  WriteImage(path, Constant(values), type, names);
}

// "PIEH", the size, then these floats at every pixel: .flo with two, .dpt with one.
void WritePieh(const std::filesystem::path& path, const std::vector<float>& values) {
  std::filesystem::create_directories(path.parent_path());
  std::string bytes = "PIEH";
  const auto add = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(std::int32_t{kWidth});
  add(std::int32_t{kHeight});
  for (int i = 0; i < kWidth * kHeight; ++i) {
    for (const float value : values) add(value);
  }
  WriteFile(path, bytes);
}

Sequence Import(const TemporaryFolder& folder, const std::string& preset) {
  ImportRequest request;
  request.folder = folder.path();
  request.preset = preset;
  request.name = "imported";
  return ImportSequence(request).sequence;
}

void ExpectMotion(const Sequence& sequence, int index, float x, float y) {
  const Image motion = LoadFrame(sequence, index, Streams::kMotion).motion;
  for (int j = 1; j < kHeight - 1; ++j) {
    EXPECT_NEAR(motion.at(4, j, 0), x, 1e-3);
    EXPECT_NEAR(motion.at(4, j, 1), y, 1e-3);
  }
}

class BlenderImport : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(BlenderImport, ReadsLayersOfAnyName) {
  const TemporaryFolder folder;
  const auto& [layer, depth] = GetParam();
  for (int frame = 1; frame <= 2; ++frame) {
    WriteChannels(folder / ("lr/shot_000" + std::to_string(frame) + ".exr"),
                  {{layer + "Combined.R", 0.25F},
                   {layer + "Combined.G", 2},
                   {layer + "Combined.B", 0},
                   {layer + "Combined.A", 1},
                   {layer + depth, frame == 1 ? 5.0F : 1e10F},
                   {layer + "Vector.X", -2},
                   {layer + "Vector.Y", 1},
                   {layer + "Vector.Z", 7},
                   {layer + "Vector.W", 9}});
  }
  const Sequence s = Import(folder, "blender");
  EXPECT_EQ(s.count, 2);
  EXPECT_EQ(s.first, 1);
  EXPECT_EQ(s.color_space, ColorSpace::kLinear);
  EXPECT_FLOAT_EQ(LoadFrame(s, 0, Streams::kColor).color.at(1, 1, 1), 2);
  EXPECT_FLOAT_EQ(LoadFrame(s, 0, Streams::kDepth).depth.at(1, 1), 1) << "5 is the far plane";
  EXPECT_FLOAT_EQ(LoadFrame(s, 1, Streams::kDepth).depth.at(1, 1), 1) << "background";
  EXPECT_EQ(s.depth->far, 5);
  ExpectMotion(s, 1, 2, 1);
}

INSTANTIATE_TEST_SUITE_P(Names, BlenderImport,
                         testing::Values(std::pair("ViewLayer.", "Depth.Z"),
                                         std::pair("My Layer.", "Depth.Z"),
                                         std::pair("ViewLayer.", "Depth.V"),
                                         std::pair("RenderLayer.", "Depth.Z"),
                                         std::pair("", "Depth.Z")));

TEST(UnrealImport, ReadsEncodedVelocityAndItsCodeZero) {
  const TemporaryFolder folder;
  for (int frame = 0; frame < 2; ++frame) {
    // 0.5 of normalised device coordinates to the right, 0.25 up.
    const float x = 0.5F * 0.2495F + 32767.0F / 65535, y = 0.25F * 0.2495F + 32767.0F / 65535;
    const bool coded = frame == 1;
    WriteChannels(folder / ("shot.000" + std::to_string(frame) + ".exr"),
                  {{"R", 1},
                   {"G", 1},
                   {"B", 1},
                   {"A", 1},
                   {"FinalImageMovieRenderQueue_WorldDepth.R", 100},
                   {"FinalImageMovieRenderQueue_MotionVectors.R", coded ? x : 0},
                   {"FinalImageMovieRenderQueue_MotionVectors.G", coded ? y : 0}});
  }
  const Sequence s = Import(folder, "unreal");
  ASSERT_TRUE(s.motion && s.depth);
  ExpectMotion(s, 1, 0.5F * kWidth / 2, -0.25F * kHeight / 2);
  ExpectMotion(s, 0, 0, 0);
}

TEST(UnityImport, ReadsNdcWithYUp) {
  const TemporaryFolder folder;
  for (const char* frame : {"0000", "0001"}) {
    WriteConstant(folder / (std::string("Beauty/b_") + frame + ".png"), {0.5F, 0.5F, 0.5F},
                  PixelType::kUint8);
    WriteConstant(folder / (std::string("Depth/d_") + frame + ".exr"), {3}, PixelType::kFloat,
                  {"R"});
    WriteConstant(folder / (std::string("MotionVectors/m_") + frame + ".exr"), {0.25F, 0.5F, 0},
                  PixelType::kFloat, {"R", "G", "B"});
  }
  const Sequence s = Import(folder, "unity");
  ASSERT_TRUE(s.motion && s.depth);
  EXPECT_EQ(s.color_space, ColorSpace::kSrgb);
  ExpectMotion(s, 1, 0.25F * kWidth / 2, -0.5F * kHeight / 2);
}

TEST(FsrImport, ReadsMotionToTheFrameBefore) {
  const TemporaryFolder folder;
  for (const char* frame : {"10", "11", "13"}) {
    WriteConstant(folder / (std::string("color/") + frame + ".exr"), {1, 2, 3}, PixelType::kHalf);
    WriteConstant(folder / (std::string("depth/") + frame + ".exr"), {0.5F}, PixelType::kFloat);
    WriteConstant(folder / (std::string("motion/") + frame + ".exr"), {2, -1}, PixelType::kFloat,
                  {"X", "Y"});
  }
  const Sequence s = Import(folder, "fsr");
  EXPECT_EQ(s.numbers, (std::vector<int>{10, 11, 13}));
  EXPECT_EQ(s.cuts, std::vector<int>{13}) << "a frame is missing before it";
  ExpectMotion(s, 1, -2, 1);
}

TEST(SintelImport, ReadsForwardFlowAndConvertsDepth) {
  const TemporaryFolder folder;
  for (const char* frame : {"0001", "0002"}) {
    WriteConstant(folder / (std::string("clean/frame_") + frame + ".png"), {0.5F, 0.5F, 0.5F},
                  PixelType::kUint8);
    WritePieh(folder / (std::string("depth/frame_") + frame + ".dpt"), {12});
  }
  WritePieh(folder / "flow/frame_0001.flo", {1, 0.5F});
  const Sequence s = Import(folder, "sintel");
  ASSERT_TRUE(s.motion && s.depth);
  EXPECT_FLOAT_EQ(LoadFrame(s, 0, Streams::kDepth).depth.at(2, 2), 1);
  ExpectMotion(s, 1, 1, 0.5F);
  ExpectMotion(s, 0, 0, 0);
}

TEST(KittiImport, ReadsCodesAndValidity) {
  const TemporaryFolder folder;
  for (const char* frame : {"10", "11"}) {
    WriteConstant(folder / (std::string("image_2/000000_") + frame + ".png"), {0.5F, 0.5F, 0.5F},
                  PixelType::kUint8);
  }
  const auto code = [](float pixels) { return (pixels * 64 + 32768) / 65535; };
  WriteConstant(folder / "flow_occ/000000_10.png", {code(1), code(-0.5F), 1.0F / 65535},
                PixelType::kUint16);
  ExpectMotion(Import(folder, "kitti"), 1, 1, -0.5F);
}

TEST(MiddleburyImport, ReadsUnknownFlowAsNone) {
  const TemporaryFolder folder;
  for (const char* frame : {"10", "11"}) {
    WriteConstant(folder / (std::string("other-data/Grove/frame") + frame + ".png"),
                  {0.5F, 0.5F, 0.5F}, PixelType::kUint8);
  }
  WritePieh(folder / "other-gt-flow/Grove/flow10.flo", {1.5F, 0});
  ExpectMotion(Import(folder, "middlebury"), 1, 1.5F, 0);
  const TemporaryFolder unknown;
  std::filesystem::copy(folder / "other-data", unknown / "other-data",
                        std::filesystem::copy_options::recursive);
  WritePieh(unknown / "other-gt-flow/Grove/flow10.flo", {1.7e9F, 1.7e9F});
  ExpectMotion(Import(unknown, "middlebury"), 1, 0, 0);
}

TEST(MobfgsrImport, ReadsPackedMotion) {
  const TemporaryFolder folder;
  for (const char* grid : {"LR_Inputs/", "HR_Inputs/"}) {
    const std::string base = grid;
    WriteConstant(folder / (base + "view/0010.png"), {0.5F, 0.5F, 0.5F}, PixelType::kUint8);
    WriteConstant(folder / (base + "depth/0010.png"), {0, 0, 0, 0}, PixelType::kUint8);
    // 1 codes the largest: a move by the whole width, and by the whole height up.
    WriteConstant(folder / (base + "motion_vectors_x/0010.png"), {1, 0, 0, 0}, PixelType::kUint8);
    WriteConstant(folder / (base + "motion_vectors_y/0010.png"), {1, 0, 0, 0}, PixelType::kUint8);
  }
  const Sequence s = Import(folder, "mobfgsr");
  ASSERT_TRUE(s.motion && s.depth && s.reference && s.reference_motion);
  ExpectMotion(s, 0, kWidth, -kHeight);
}

TEST(Import, RefusesWhatItCannotUse) {
  const TemporaryFolder folder;
  ExpectError([&] { Import(folder, "maya"); }, {"'maya' is not a preset"});
  ExpectError([&] { Import(folder, "fsr"); }, {"no numbered images"});
  WriteConstant(folder / "normals/0001.exr", {1, 2}, PixelType::kFloat, {"U", "V"});
  ExpectError([&] { Import(folder, "blender"); }, {"no colour that the preset"});
  WriteConstant(folder / "color/0001.exr", {1, 2, 3}, PixelType::kHalf);
  Import(folder, "fsr");
  ExpectError([&] { Import(folder, "fsr"); }, {"is there already"});
}

TEST(Import, GodotsVelocityAndReversedDepth) {
  const TemporaryFolder folder;
  for (const char* number : {"0001", "0002"}) {
    const auto file = [&](const char* kind) {
      return folder / fmt::format("{}/{}.exr", kind, number);
    };
    WriteConstant(file("color"), {0.5, 0.5, 0.5}, PixelType::kHalf);
    WriteConstant(file("depth"), {0.5}, PixelType::kFloat, {"R"});
    WriteConstant(file("velocity"), {0.125, -0.25}, PixelType::kFloat, {"R", "G"});
  }
  ImportRequest request;
  request.folder = folder.path();
  request.preset = "godot";
  ExpectError([&] { ImportSequence(request); }, {"godot", "--near"});
  request.near = 0.1;
  const Sequence s = ImportSequence(request).sequence;
  ExpectMotion(s, 1, -0.125F * kWidth, 0.25F * kHeight);
  EXPECT_NEAR(LoadFrame(s, 1, Streams::kDepth).depth.at(0, 0), 2, 1e-5);  // near planes
}

// Two captures at two ratios.
void WriteCaptures(const TemporaryFolder& folder) {
  for (const char* name : {"0000", "0001"}) {
    std::string frames;
    for (int i = 0; i < 3; ++i) {
      const auto write = [&](const char* kind, const std::vector<float>& values,
                             const std::vector<std::string>& names) {
        WriteConstant(folder / fmt::format("{}/{}/{:04}.exr", kind, name, i), values,
                      PixelType::kFloat, names);
      };
      for (const char* ratio : {"x1_5", "x2"}) {
        const auto input = [&](const char* kind) { return fmt::format("{}/{}", ratio, kind); };
        write(input("color").c_str(), {0.5, 0.25, 0.125}, {"R", "G", "B"});
        write(input("depth").c_str(), {0.5}, {"R"});
        write(input("motion").c_str(), {0.125, 0.25}, {"R", "G"});
      }
      write("ground_truth", {0.25, 0.5, 1}, {"R", "G", "B"});
      write("motion_gt", {0.125, 0.25}, {"R", "G"});
      frames += fmt::format(R"({}{{"FrameNumber": {}, "Jitter": {{"X": 0.25, "Y": {}}},
          "CameraNearPlane": 0.1, "CameraFarPlane": -1.0, "CameraCut": {}, "Exposure": 1}})",
                            i > 0 ? ", " : "", i, -0.125 * i, i == 2);
    }
    WriteFile(folder / (name + std::string(".json")),
              R"({"Version": "1.0.1", "ReverseZ": true, "Frames": [)" + frames + "]}");
  }
}

TEST(Import, ArmsCapturesByNameAndScale) {
  const TemporaryFolder folder;
  WriteCaptures(folder);
  ImportRequest request;
  request.folder = folder.path();
  request.preset = "arm";
  ExpectError([&] { ImportSequence(request); }, {"0000 at x2", "0001 at x1_5", "--capture"});
  request.capture = "0001";
  ExpectError([&] { ImportSequence(request); }, {"2 captures", "--scale"});
  request.scale = 2;
  const ImportResult result = ImportSequence(request);
  const Sequence& s = result.sequence;
  EXPECT_EQ(result.manifest, folder / "sequence-0001.json");
  EXPECT_EQ(s.color.path, "x2/color/0001/%04d.exr");
  EXPECT_EQ(s.reference->path, "ground_truth/0001/%04d.exr");
  EXPECT_EQ(s.reference_motion->path, "motion_gt/0001/%04d.exr");
  EXPECT_EQ(s.cuts, std::vector{2});
  ASSERT_EQ(s.jitter.size(), 3U);
  EXPECT_EQ(s.jitter[1].y, -0.125);
  ExpectMotion(s, 1, 0.125F * kWidth, 0.25F * kHeight);
  EXPECT_NEAR(LoadFrame(s, 1, Streams::kDepth).depth.at(0, 0), 2, 1e-5);

  WriteFile(folder / "0001.json", R"({"ReverseZ": true, "Frames": []})");
  request.replace = true;
  ExpectError([&] { ImportSequence(request); }, {"0001.json", "Frames", "no values"});
  WriteFile(folder / "0001.json", R"({"ReverseZ": 1, "Frames": []})");
  ExpectError([&] { ImportSequence(request); }, {"ReverseZ", "true or false"});
}

TEST(Import, TakesMasksAlphaAndSizes) {
  const TemporaryFolder folder;
  for (const char* number : {"0001", "0002"}) {
    WriteConstant(folder / fmt::format("color/{}.png", number), {0.5, 0.5, 0.5, 0.25},
                  PixelType::kUint8);
    WriteConstant(folder / fmt::format("mask/{}.png", number), {1, 0, 0}, PixelType::kUint8);
  }
  WriteImage(folder / "color/0002.png", Image(kWidth / 2, kHeight / 2, 4), PixelType::kUint8);
  ImportRequest request;
  request.folder = folder.path();
  request.preset = "fsr";
  request.reactive = "mask/%04d.png";
  request.alpha = true;
  const Sequence s = ImportSequence(request).sequence;
  EXPECT_EQ(s.render_sizes, (std::vector<GridSize>{{kWidth, kHeight}, {kWidth / 2, kHeight / 2}}));
  EXPECT_EQ(s.alpha->color, AlphaKind::kStraight);
  const Frame frame = LoadFrame(s, 0, Streams::kColor | Streams::kAlpha | Streams::kReactive);
  EXPECT_NEAR(frame.alpha.at(1, 1), 0.25, 0.003);
  EXPECT_NEAR(frame.color.at(1, 1), 0.125, 0.003);
  EXPECT_EQ(frame.reactive.at(1, 1), 1);
  request.replace = true;
  request.reactive = "../%04d.png";
  ExpectError([&] { ImportSequence(request); }, {"reactive.path", ".."});
  request.reactive = "none/%04d.png";
  ExpectError([&] { ImportSequence(request); }, {"none/0001.png"});
}

TEST(Import, TakesFieldsFromAFile) {
  const TemporaryFolder folder;
  WriteConstant(folder / "color/0001.exr", {1, 2, 3}, PixelType::kHalf);
  WriteFile(folder / "side.json",
            R"({"jitter": {"units": "render-pixels", "y": "up", "offsets": [[0.25, 0.5]]}})");
  ImportRequest request;
  request.folder = folder.path();
  request.preset = "fsr";
  request.fields = folder / "side.json";
  const Sequence s = ImportSequence(request).sequence;
  ASSERT_EQ(s.jitter.size(), 1U);
  EXPECT_EQ(s.jitter[0].y, -0.5);
}

TEST(NumberedFiles, GroupsByTheLastNumber) {
  const TemporaryFolder folder;
  for (const char* name : {"a1_0008.png", "a1_0009.png", "a1_0010.png", "b9.png", "b10.png",
                           "readme.txt", ".hidden_1.png"}) {
    WriteFile(folder / name, "");
  }
  const auto found = FindNumberedFiles(folder.path());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].pattern, "a1_%04d.png");
  EXPECT_EQ(found[0].numbers, (std::vector<int>{8, 9, 10}));
  EXPECT_EQ(found[1].pattern, "b%d.png");
}

TEST(Dpt, RefusesDamagedFiles) {
  const TemporaryFolder folder;
  WritePieh(folder / "a.dpt", {2});
  EXPECT_EQ(ReadDpt(folder / "a.dpt").at(3, 3), 2);
  WriteFile(folder / "b.dpt", ReadFile(folder / "a.dpt").substr(0, 20));
  ExpectError([&] { ReadDpt(folder / "b.dpt"); }, {"bytes; expected"});
  WriteFile(folder / "c.dpt", "no");
  ExpectError([&] { ReadDpt(folder / "c.dpt"); }, {"does not begin with PIEH"});
}

}  // namespace
}  // namespace warplut
