#include "datasets/import/capture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "datasets/json_fields.h"

namespace warplut {
namespace {

std::vector<std::string> Parts(const std::string& pattern) {
  std::vector<std::string> parts;
  for (const auto& part : std::filesystem::path(pattern)) parts.push_back(part.string());
  return parts;
}

// "x2" and "x1_5" as numbers.
std::optional<double> RatioOf(std::string folder) {
  if (folder.size() < 2 || folder.front() != 'x') return std::nullopt;
  std::replace(folder.begin(), folder.end(), '_', '.');
  double ratio = 0;
  const char* end = folder.data() + folder.size();
  const auto [stop, error] = std::from_chars(folder.data() + 1, end, ratio);
  if (error != std::errc() || stop != end) return std::nullopt;
  return ratio;
}

}  // namespace

Capture FindCapture(const std::vector<NumberedFiles>& files, const std::string& name,
                    double scale) {
  std::vector<Capture> found;
  std::vector<std::string> all;
  for (const NumberedFiles& one : files) {
    const std::vector<std::string> parts = Parts(one.pattern);
    if (parts.size() != 4 || parts[1] != "color") continue;
    const auto ratio = RatioOf(parts[0]);
    if (!ratio) continue;
    all.push_back(fmt::format("{} at {}", parts[2], parts[0]));
    if (!name.empty() && parts[2] != name) continue;
    if (scale != 1 && std::abs(*ratio - scale) > 1e-6) continue;
    found.push_back({.name = parts[2], .ratio = parts[0]});
  }
  if (found.size() == 1) return found.front();
  if (all.empty()) {
    throw Error("there is no capture; expected files like x2/color/0000/0000.exr");
  }
  throw Error(
      fmt::format("{} captures are of that name and scale; expected one of {}, named by "
                  "--capture and --scale",
                  found.size(), fmt::join(all, ", ")));
}

bool IsOfCapture(const Capture& capture, const std::string& pattern) {
  const std::vector<std::string> parts = Parts(pattern);
  if (parts.size() == 4) return parts[0] == capture.ratio && parts[2] == capture.name;
  return parts.size() == 3 && (parts[0] == "ground_truth" || parts[0] == "motion_gt") &&
         parts[1] == capture.name;
}

CaptureMetadata ReadCaptureMetadata(const std::filesystem::path& path) {
  const nlohmann::json json = ReadJson(path, kMaxManifestBytes);
  JsonFields root(json, JsonPlace(path.string(), ""));
  CaptureMetadata metadata;
  const auto flag = [](JsonFields& fields, const char* name) {
    const nlohmann::json& value = fields.Take(name);
    if (!value.is_boolean()) fields.At(name).Refuse(value, "true or false");
    return value.get<bool>();
  };
  metadata.reversed_depth = flag(root, "ReverseZ");
  const JsonPlace at = root.At("Frames");
  std::size_t index = 0;
  for (const nlohmann::json& element : at.Array(root.Take("Frames"))) {
    JsonFields frame(element, at.Element(index));
    // The plugin and its specification differ in this name.
    const int number = frame.Integer(frame.Has("FrameNumber") ? "FrameNumber" : "Frame");
    JsonFields jitter = frame.Object("Jitter");
    metadata.jitter[number] = {jitter.Number("X"), jitter.Number("Y")};
    if (frame.Has("CameraCut") && flag(frame, "CameraCut")) metadata.cuts.push_back(number);
    if (index++ > 0) continue;
    metadata.near = frame.Number("CameraNearPlane");
    metadata.far = frame.Number("CameraFarPlane");
    if (metadata.far < 0) metadata.far = std::numeric_limits<double>::infinity();
  }
  if (index == 0) at.Fail("has no values; expected one for each frame");
  std::sort(metadata.cuts.begin(), metadata.cuts.end());
  return metadata;
}

}  // namespace warplut
