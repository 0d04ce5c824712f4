#include "datasets/import/import_preset.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"

namespace warplut {
namespace {

using Channels = std::vector<std::vector<std::string>>;

const Channels kRgb = {{"R", "G", "B"}};
const std::vector<std::string> kColorWords = {"color", "colour", "image"};
const std::vector<std::string> kMotionWords = {"motion", "velocity", "flow", "mv", "vector"};
const std::vector<std::string> kDepthWords = {"depth"};

// Blender: the vector pass has the motion to the frame before in X, Y and that to the next in Z, W,
// in pixels, y up; the sky has the depth 1e10 and no motion.
ImportPreset Blender() {
  ImportPreset preset;
  preset.name = "blender";
  preset.purpose = "multilayer OpenEXR of Cycles and EEVEE with the passes Z and Vector";
  preset.color = {{{"Combined.R", "Combined.G", "Combined.B"}, {"Image.R", "Image.G", "Image.B"}},
                  {}};
  preset.depth = {{{"Depth.Z"}, {"Depth.V"}, {"Z"}}, {}};
  preset.motion = {{{"Vector.X", "Vector.Y"}}, {}};
  preset.motion_stream.direction = MotionDirection::kCurrentToPrevious;
  preset.motion_stream.y = YAxis::kUp;
  preset.depth_stream.background = 1e10;
  return preset;
}

// Unreal: velocity v of normalised device coordinates is stored as 0.2495 v + 32767 / 65535; code 0
// means that only the camera moves the pixel. Depth is in centimetres.
ImportPreset Unreal() {
  constexpr double kScale = 1 / (0.499 * 0.5);
  constexpr double kBias = -32767.0 / 65535 * kScale;
  ImportPreset preset;
  preset.name = "unreal";
  preset.purpose = "OpenEXR of the Movie Render Queue with WorldDepth and encoded velocity";
  preset.color = {{{"FinalImage.R", "FinalImage.G", "FinalImage.B"}, {"R", "G", "B"}},
                  {"finalimage", "color", "colour"}};
  preset.depth = {{{"WorldDepth.R"}, {"Depth.R"}, {"R"}, {"Z"}}, {"depth"}};
  preset.motion = {
      {{"MotionVectors.R", "MotionVectors.G"}, {"Velocity.R", "Velocity.G"}, {"R", "G"}},
      kMotionWords};
  preset.motion_stream.scale = {kScale, kScale};
  preset.motion_stream.bias = {kBias, kBias};
  preset.motion_stream.units = MotionUnits::kNdc;
  preset.motion_stream.y = YAxis::kUp;
  preset.motion_stream.invalid = InvalidMotion{.values = {kBias}};
  return preset;
}

// Buffers of an engine in files of their own: colour, depth and motion by words in their paths.
ImportPreset Buffers(std::string_view name, std::string_view purpose,
                     std::vector<std::string> color_words) {
  ImportPreset preset;
  preset.name = name;
  preset.purpose = purpose;
  preset.color = {kRgb, std::move(color_words)};
  preset.depth = {{{"Z"}, {"R"}, {"Y"}}, kDepthWords};
  preset.motion = {{{"X", "Y"}, {"R", "G"}}, kMotionWords};
  return preset;
}

ImportPreset Unity() {
  ImportPreset preset =
      Buffers("unity", "AOV images of the Recorder: beauty, depth, motion vectors",
              {"beauty", "color", "colour", "image"});
  preset.motion.channels = {{"R", "G"}, {"X", "Y"}};
  preset.motion_stream.units = MotionUnits::kNdc;
  preset.motion_stream.y = YAxis::kUp;
  return preset;
}

ImportPreset Fsr() {
  ImportPreset preset = Buffers(
      "fsr", "inputs of FSR: motion in pixels from this frame to the one before", kColorWords);
  preset.motion_stream.direction = MotionDirection::kCurrentToPrevious;
  return preset;
}

// Godot 4: motion in UV from this frame to the one before (velocity buffer), depth reversed from
// version 4.3 on.
ImportPreset Godot() {
  ImportPreset preset = Buffers(
      "godot", "buffers of Godot 4.3 and later: velocity in UV, reversed depth", kColorWords);
  preset.depth_stream.kind = DepthKind::kReversed;
  preset.motion_stream.units = MotionUnits::kUv;
  preset.motion_stream.direction = MotionDirection::kCurrentToPrevious;
  return preset;
}

// Motion in UV from the frame before, y down; depth and jitter as the capture's JSON says.
ImportPreset Arm() {
  ImportPreset preset;
  preset.name = "arm";
  preset.purpose = "captures of Arm's neural graphics tools";
  preset.color = {kRgb, {"/color/", "ground_truth/"}};
  preset.depth = {{{"R"}, {"Z"}, {"Y"}}, {"/depth/"}};
  preset.motion = {{{"R", "G"}, {"X", "Y"}}, {"/motion/", "motion_gt/"}};
  preset.motion_stream.units = MotionUnits::kUv;
  preset.captures = true;
  return preset;
}

ImportPreset Flow(std::string_view name, std::string_view purpose,
                  std::vector<std::string> color_words) {
  ImportPreset preset;
  preset.name = name;
  preset.purpose = purpose;
  preset.color = {{}, std::move(color_words)};
  preset.depth = {{}, kDepthWords};
  preset.motion = {{}, {"flow"}};
  preset.motion_stream.direction = MotionDirection::kCurrentToNext;
  return preset;
}

ImportPreset Kitti() {
  ImportPreset preset = Flow("kitti", "KITTI: 16-bit PNG of forward flow with validity",
                             {"image_2", "image_0", "colored_0"});
  preset.motion.channels = {{"R", "G"}};
  preset.motion.words = {"flow_occ", "flow_noc", "flow"};
  // (code - 2^15) / 64
  preset.motion_stream.scale = {65535.0 / 64, 65535.0 / 64};
  preset.motion_stream.bias = {-512, -512};
  preset.motion_stream.invalid = InvalidMotion{.channel = "B"};
  return preset;
}

// The layout of the frames that were published with the paper's code.
ImportPreset Mobfgsr() {
  ImportPreset preset;
  preset.name = "mobfgsr";
  preset.purpose = "the released sample of Mob-FGSR: packed depth and motion";
  preset.color = {{}, {"view"}};
  preset.depth = {{}, {"depth"}};
  preset.motion = {{}, {"motion_vectors"}};
  preset.two_motion_files = true;
  preset.motion_stream.encoding = Encoding::kRgba8Base255;
  preset.motion_stream.scale = {2, -2};
  preset.motion_stream.bias = {-1, 1};
  preset.motion_stream.units = MotionUnits::kUv;
  preset.depth_stream.encoding = Encoding::kRgba8Base255;
  return preset;
}

}  // namespace

std::span<const ImportPreset> ImportPresets() {
  static const std::vector<ImportPreset> presets = {
      Blender(),
      Unreal(),
      Unity(),
      Godot(),
      Fsr(),
      Arm(),
      Flow("sintel", "MPI Sintel: .flo of forward flow, .dpt depth", {"clean", "final", "albedo"}),
      Kitti(),
      Flow("middlebury", "Middlebury: .flo of forward flow, 1e9 where unknown",
           {"data", "frame", "color"}),
      Mobfgsr()};
  return presets;
}

const ImportPreset& FindImportPreset(const std::string& name) {
  std::string known;
  for (const ImportPreset& preset : ImportPresets()) {
    if (preset.name == name) return preset;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", preset.name);
  }
  throw Error(fmt::format("'{}' is not a preset; expected one of {}", name, known));
}

}  // namespace warplut
