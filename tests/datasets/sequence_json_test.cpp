#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "datasets/sequence/sequence.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

using nlohmann::json;

const char* const kManifest = R"({
  "format": "warplut-sequence", "version": 1, "name": "demo",
  "frames": {"first": 10, "count": 3},
  "render": {"width": 480, "height": 270},
  "output": {"width": 960, "height": 540},
  "color_space": "linear",
  "streams": {
    "color": {"path": "lr/color/%04d.exr", "grid": "render", "channels": ["R", "G", "B"]},
    "depth": {"path": "lr/depth/%04d.exr", "grid": "render", "channels": ["Z"],
              "kind": "reversed", "near": 0.1, "far": null},
    "motion": {"path_x": "mx/%d.png", "path_y": "my/%d.png", "grid": "render",
               "encoding": "rgba8-base255",
               "scale": [2, -2], "bias": -1, "units": "ndc",
               "direction": "current-to-previous", "y": "up"},
    "reference": {"path": "hr/color/%04d.png", "grid": "output"},
    "reference_depth": {"path": "hr/depth/%04d.exr", "grid": "output",
                        "kind": "linear", "near": 0, "far": 1},
    "reference_motion": {"path": "hr/motion/%04d.exr", "grid": "output", "channels": ["X", "Y"],
                         "units": "pixels", "direction": "previous-to-current", "y": "down"}
  },
  "jitter": {"units": "render-pixels", "y": "up", "offsets": [[0.25, 0.125], [-0.5, 0]]},
  "camera": [
    {"view": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],
     "projection": [1,0,0,0, 0,1,0,0, 0,0,-1,-0.2, 0,0,-1,0]},
    {"view": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1],
     "projection": [1,0,0,0, 0,1,0,0, 0,0,-1,-0.2, 0,0,-1,0]},
    {"view": [1,0,0,2, 0,1,0,0, 0,0,1,0, 0,0,0,1],
     "projection": [1,0,0,0, 0,1,0,0, 0,0,-1,-0.2, 0,0,-1,0]}
  ],
  "cuts": [11]
})";

class ReadSequenceTest : public testing::Test {
 protected:
  Sequence Read(const std::string& text) {
    std::ofstream(folder_ / Sequence::kManifest) << text;
    return ReadSequence(folder_.path());
  }

  // The manifest with the value at `pointer` replaced, or removed where it is kGone, is refused.
  void Refused(const std::string& pointer, const json& value,
               std::initializer_list<std::string> pieces) {
    json manifest = json::parse(kManifest);
    const json::json_pointer at(pointer);
    json& parent = manifest.at(at.parent_pointer());
    if (!value.is_discarded()) {
      manifest[at] = value;
    } else if (parent.is_array()) {
      parent.erase(std::stoul(at.back()));
    } else {
      parent.erase(at.back());
    }
    SCOPED_TRACE(pointer);
    ExpectError([&] { Read(manifest.dump()); }, pieces);
  }

  TemporaryFolder folder_;
};

const json kGone = json(json::value_t::discarded);

TEST_F(ReadSequenceTest, EveryField) {
  const Sequence s = Read(kManifest);
  EXPECT_EQ(s.folder, folder_.path());
  EXPECT_EQ(s.name, "demo");
  EXPECT_EQ(s.first, 10);
  EXPECT_EQ(s.count, 3);
  EXPECT_EQ(s.render, (GridSize{480, 270}));
  EXPECT_EQ(s.output, (GridSize{960, 540}));
  EXPECT_EQ(s.color_space, ColorSpace::kLinear);
  EXPECT_EQ(s.color.path, "lr/color/%04d.exr");
  EXPECT_EQ(s.color.channels.size(), 3U);
  ASSERT_TRUE(s.depth && s.motion && s.reference && s.reference_depth && s.reference_motion);
  EXPECT_EQ(s.depth->kind, DepthKind::kReversed);
  EXPECT_EQ(s.depth->near, 0.1);
  EXPECT_TRUE(std::isinf(s.depth->far));
  EXPECT_EQ(s.motion->path_y, "my/%d.png");
  EXPECT_EQ(s.motion->encoding, Encoding::kRgba8Base255);
  EXPECT_EQ(s.motion->scale[1], -2);
  EXPECT_EQ(s.motion->bias[1], -1);
  EXPECT_EQ(s.motion->units, MotionUnits::kNdc);
  EXPECT_EQ(s.motion->direction, MotionDirection::kCurrentToPrevious);
  EXPECT_EQ(s.motion->y, YAxis::kUp);
  EXPECT_EQ(s.reference_depth->encoding, Encoding::kFloat);
  ASSERT_EQ(s.jitter.size(), 2U);
  EXPECT_EQ(s.jitter[0].y, -0.125);
  ASSERT_EQ(s.camera.size(), 3U);
  EXPECT_EQ(s.camera[2].view[3], 2);
  EXPECT_EQ(s.camera[0].projection[11], -0.2);
  EXPECT_EQ(s.cuts, std::vector<int>{11});
}

TEST_F(ReadSequenceTest, WrittenTextReadsBackTheSame) {
  const std::string text = SequenceJson(Read(kManifest));
  EXPECT_EQ(SequenceJson(Read(text)), text);
  const Sequence s = Read(text);
  EXPECT_TRUE(std::isinf(s.depth->far));
  EXPECT_EQ(s.jitter[0].y, -0.125);
  EXPECT_EQ(s.motion->bias, (std::array<double, 2>{-1, -1}));
}

TEST_F(ReadSequenceTest, InvalidMotionIsAValueValuesOrAChannel) {
  const auto read = [&](const json& invalid) {
    json manifest = json::parse(kManifest);
    json& motion = manifest["streams"]["reference_motion"];
    motion["channels"] = {"R", "G"};
    motion["invalid"] = invalid;
    const Sequence s = Read(manifest.dump());
    EXPECT_EQ(SequenceJson(Read(SequenceJson(s))), SequenceJson(s));
    return *s.reference_motion->invalid;
  };
  EXPECT_EQ(read(-512).values, std::vector<double>{-512});
  EXPECT_EQ(read({1e10, 65504}).values, (std::vector<double>{1e10, 65504}));
  EXPECT_TRUE(read(json::array()).values.empty());
  EXPECT_EQ(read({{"channel", "B"}}).channel, "B");
  EXPECT_FALSE(Read(kManifest).reference_motion->invalid);

  Refused("/streams/reference_motion/invalid", "B", {"reference_motion.invalid", "a number"});
  Refused("/streams/reference_motion/invalid", {{"channel", ""}}, {"invalid.channel", "is empty"});
  Refused("/streams/reference_motion/invalid", {{"name", "B"}}, {"invalid.channel", "is missing"});
  Refused("/streams/reference_motion/invalid", json::array({"x"}), {"invalid[0]", "a number"});
  Refused("/streams/motion/invalid", {{"channel", "B"}},
          {"motion.invalid", "expected it with one"});
  EXPECT_THROW(read({{"channel", "R"}}), Error);
}

TEST_F(ReadSequenceTest, OptionalPartsMayBeAbsent) {
  json manifest = json::parse(kManifest);
  for (const char* name : {"jitter", "camera", "cuts"}) manifest.erase(name);
  manifest["streams"] = {{"color", {{"path", "%d.png"}, {"grid", "render"}}}};
  const Sequence s = Read(manifest.dump());
  EXPECT_EQ(AvailableStreams(s), Streams::kColor);
  EXPECT_TRUE(s.jitter.empty() && s.camera.empty() && s.cuts.empty());
}

TEST_F(ReadSequenceTest, StreamsMayLieBelowAFolderThatTheCallerNames) {
  namespace fs = std::filesystem;
  const fs::path inner = folder_ / "shots/one";
  fs::create_directories(inner);
  fs::create_directories(folder_ / "other");
  const auto read = [&](const char* path, const fs::path& streams_below) {
    json manifest = json::parse(kManifest);
    manifest["streams"]["reference"]["path"] = path;
    std::ofstream(inner / Sequence::kManifest) << manifest.dump();
    return ReadSequence(inner, streams_below);
  };
  const Sequence s = read("../../shared/%04d.png", folder_.path());
  EXPECT_EQ(FrameFiles(s, 0, Streams::kReference).front(), inner / "../../shared/0010.png");
  EXPECT_EQ(SequenceJson(s), SequenceJson(read("../../shared/%04d.png", folder_ / "other/..")));
  EXPECT_NO_THROW(read("../shared/%04d.png", folder_ / "shots"));
  ExpectError([&] { read("../shared/%04d.png", {}); }, {"reference.path", "--streams-below"});
  ExpectError([&] { read("../../shared/%04d.png", folder_ / "shots"); },
              {"reference.path", "at most 1 '..'"});
  ExpectError([&] { read("a/%04d.png", folder_ / "other"); },
              {"one", "does not lie below", "other"});
  ExpectError([&] { read("a/%04d.png", folder_ / "none"); }, {"none", "no folder"});
}

TEST_F(ReadSequenceTest, WhatIsNoManifestIsRefused) {
  ExpectError([&] { ReadSequence(folder_.path()); }, {Sequence::kManifest, "does not exist"});
  ExpectError([&] { Read("{\"format\": 1}"); }, {(folder_ / Sequence::kManifest).string()});
  ExpectError([&] { Read("{"); }, {Sequence::kManifest, "is not JSON"});
  ExpectError([&] { Read("[]"); }, {"expected an object"});
  ExpectError([&] { Read(R"({"format": "a", "format": "b"})"); }, {"'format'", "twice"});
  ExpectError([&] { Read(R"({"format": 1e999})"); }, {"at most 3.4"});
}

TEST_F(ReadSequenceTest, MissingAndUnknownFieldsAreNamed) {
  for (const char* field : {"/format",
                            "/version",
                            "/name",
                            "/frames",
                            "/frames/first",
                            "/frames/count",
                            "/render",
                            "/render/width",
                            "/output/height",
                            "/color_space",
                            "/streams",
                            "/streams/color",
                            "/streams/color/path",
                            "/streams/color/grid",
                            "/streams/depth/kind",
                            "/streams/depth/near",
                            "/streams/depth/far",
                            "/streams/motion/path_x",
                            "/streams/motion/units",
                            "/streams/motion/direction",
                            "/streams/motion/y",
                            "/jitter/offsets",
                            "/jitter/y",
                            "/jitter/units",
                            "/camera/0/view",
                            "/camera/1/projection"}) {
    const std::string name = std::string(field).substr(std::string(field).rfind('/') + 1);
    Refused(field, kGone, {name, "is missing"});
  }
  for (const char* field :
       {"/extra", "/frames/extra", "/render/extra", "/streams/extra", "/streams/color/extra",
        "/streams/depth/extra", "/streams/motion/extra", "/jitter/extra", "/camera/2/extra"}) {
    Refused(field, 1, {"extra", "is unknown"});
  }
}

TEST_F(ReadSequenceTest, TypesAndNamesAreChecked) {
  Refused("/format", "other", {"'format'", "\"other\"", "warplut-sequence"});
  Refused("/version", 3, {"'version'", "is 3", "expected 1 or 2"});
  Refused("/version", 1.5, {"'version'", "whole number"});
  Refused("/name", 3, {"'name'", "text"});
  Refused("/frames/count", 2.5, {"'frames.count'", "2.5", "whole number"});
  Refused("/frames/count", 1e18, {"'frames.count'"});
  Refused("/frames/count", std::int64_t{1} << 40, {"'frames.count'", "at most"});
  Refused("/frames/first", -(std::int64_t{1} << 40), {"'frames.first'", "at most"});
  Refused("/color_space", "rgb", {"'color_space'", "\"rgb\"", "srgb or linear"});
  Refused("/streams/depth/kind", "z", {"'streams.depth.kind'", "linear or forward or reversed"});
  Refused("/streams/depth/near", "0.1", {"'streams.depth.near'", "number"});
  Refused("/streams/depth/scale", {1, 2}, {"'streams.depth.scale'", "number"});
  Refused("/streams/motion/units", "px", {"'streams.motion.units'", "pixels or uv or ndc"});
  Refused("/streams/motion/encoding", "rgba8",
          {"'streams.motion.encoding'", "float or rgba8-base255"});
  Refused("/streams/motion/scale", {1, 2, 3}, {"'streams.motion.scale'", "3 values", "expected 2"});
  Refused("/streams/motion/scale", {1, "a"}, {"'streams.motion.scale[1]'", "number"});
  Refused("/streams/color/grid", "output", {"'streams.color.grid'", "\"output\"", "\"render\""});
  Refused("/streams/color/channels", json::array(), {"'streams.color.channels'", "no names"});
  Refused("/streams/color/channels", {1}, {"'streams.color.channels[0]'", "text"});
  Refused("/jitter/units", "pixels", {"'jitter.units'", "render-pixels"});
  Refused("/jitter/offsets", json::array(), {"'jitter.offsets'", "no values"});
  Refused("/jitter/offsets/1", {0.5}, {"'jitter.offsets[1]'", "1 values", "expected 2"});
  Refused("/camera/1/view", {1, 2}, {"'camera[1].view'", "2 values", "expected 16"});
  Refused("/camera", json::array(), {"'camera'", "no values"});
  Refused("/cuts", 11, {"'cuts'"});
  Refused("/cuts/0", "11", {"'cuts[0]'", "whole number"});
}

TEST_F(ReadSequenceTest, RangesAreChecked) {
  Refused("/name", "", {"'name'"});
  Refused("/name", "a/b", {"'name'", "a/b"});
  Refused("/name", std::string(201, 'n'), {"'name'", "1 to 200 bytes"});
  Refused("/frames/first", -1, {"'frames.first'", "-1", "0 or more"});
  Refused("/frames/first", 2147483647, {"'frames.first'", "2^31"});
  Refused("/frames/count", 0, {"'frames.count'", "is 0"});
  Refused("/render/width", 0, {"'render.width'", "is 0"});
  Refused("/output/height", 40000, {"'output.height'", "40000", "32768"});
  Refused("/output/width", 479, {"'output.width'", "479", "1 to 4 times"});
  Refused("/output/height", 1081, {"'output.height'", "1081", "1 to 4 times"});
  Refused("/streams/color/path", "../%d.png", {"'streams.color.path'", "../%d.png", ".."});
  Refused("/streams/depth/path", "/%d.png", {"'streams.depth.path'", "absolute"});
  Refused("/streams/motion/path_y", "a.png", {"'streams.motion.path_y'", "0 conversions"});
  Refused("/streams/motion/path", "%d.png", {"'streams.motion.path'", "path_x"});
  Refused("/streams/reference_motion/encoding", "rgba8-base255",
          {"'streams.reference_motion.path'", "path_x and path_y"});
  Refused("/streams/color/channels", {"R", "G"}, {"'streams.color.channels'", "2 names"});
  Refused("/streams/depth/channels", {"A", "B"}, {"'streams.depth.channels'", "expected 1"});
  Refused("/streams/depth/channels", {""}, {"'streams.depth.channels'", "empty name"});
  Refused("/streams/depth/scale", 0, {"'streams.depth.scale'", "other than 0"});
  Refused("/streams/depth/near", 0, {"'streams.depth.near'", "more than 0"});
  Refused("/streams/depth/far", 0.05, {"'streams.depth.far'", "more than near"});
  Refused("/streams/reference_depth/near", -1, {"'streams.reference_depth.near'", "0 or more"});
  Refused("/streams/reference_depth/far", nullptr,
          {"'streams.reference_depth.far'", "only reversed"});
  Refused("/jitter/offsets/0", {5, 0}, {"'jitter.offsets[0]'", "is 5"});
  Refused("/camera/2", kGone, {"'camera'", "2 values", "3 frames"});
  Refused("/cuts", {13}, {"'cuts[0]'", "13", "10 to 12"});
  Refused("/cuts", {12, 11}, {"'cuts[1]'", "11"});
}

TEST(SequenceJson, RefusesWhatIsNotValid) {
  ExpectError([] { SequenceJson(Sequence{}); }, {"cannot be written", "'name'"});
}

}  // namespace
}  // namespace warplut
