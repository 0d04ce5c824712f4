// sequence.json: Sequence to text.
#include <fmt/format.h>

#include <utility>

#include "datasets/error.h"
#include "datasets/json_fields.h"
#include "datasets/sequence/sequence_names.h"

namespace warplut {
namespace {

using Json = nlohmann::ordered_json;

Json Channels(const std::vector<std::string>& channels, Json stream) {
  if (!channels.empty()) stream["channels"] = channels;
  return stream;
}

// `base` with encoding, scale and bias where they are not what a reader takes without them.
template <class Stream>
Json Encoded(const Stream& s, Json base) {
  const Stream otherwise;
  Json json = Channels(s.channels, std::move(base));
  if (s.encoding != otherwise.encoding) json["encoding"] = NameOf(kEncodings, s.encoding);
  if (s.scale != otherwise.scale) json["scale"] = s.scale;
  if (s.bias != otherwise.bias) json["bias"] = s.bias;
  return json;
}

Json ToJson(const ColorStream& s, const char* grid) {
  return Channels(s.channels, {{"path", s.path}, {"grid", grid}});
}

Json ToJson(const MaskStream& s) {
  return Channels(s.channels, {{"path", s.path}, {"grid", kRenderGridName}});
}

Json ToJson(const AlphaStream& s, const char* grid) {
  Json json = Channels(s.channels, {{"path", s.path}, {"grid", grid}});
  json["color"] = NameOf(kAlphaKinds, s.color);
  return json;
}

Json ToJson(const LayerStream& s) {
  Json json = Channels(s.channels, {{"path", s.path}, {"grid", kOutputGridName}});
  json["alpha"] = NameOf(kAlphaKinds, s.alpha);
  return json;
}

Json ToJson(const DepthStream& s, const char* grid) {
  Json json = Encoded(s, {{"path", s.path}, {"grid", grid}});
  json["kind"] = NameOf(kDepthKinds, s.kind);
  json["near"] = s.near;
  json["far"] = s.far;  // infinity becomes null
  if (s.background) json["background"] = *s.background;
  return json;
}

Json ToJson(const MotionStream& s, const char* grid) {
  Json json =
      s.path.empty() ? Json{{"path_x", s.path_x}, {"path_y", s.path_y}} : Json{{"path", s.path}};
  json["grid"] = grid;
  json = Encoded(s, std::move(json));
  json["units"] = NameOf(kMotionUnits, s.units);
  json["direction"] = NameOf(kDirections, s.direction);
  json["y"] = NameOf(kYAxes, s.y);
  if (s.invalid) {
    json["invalid"] = s.invalid->channel.empty() ? Json(s.invalid->values)
                                                 : Json{{"channel", s.invalid->channel}};
  }
  if (s.frame_offset != 0) json["frame_offset"] = s.frame_offset;
  if (s.contains_jitter) json["jitter"] = NameOf(kJitterIn, true);
  return json;
}

// The elements of `json`, one on a line, so that a person can read a camera or a stream at a
// glance.
std::string Lines(const Json& json) {
  const bool object = json.is_object();
  std::string lines = object ? "{" : "[";
  const char* separator = "\n  ";
  for (const auto& [name, value] : json.items()) {
    lines += separator + (object ? JsonText(Json(name)) + ": " : "") + JsonText(value);
    separator = ",\n  ";
  }
  return lines + (object ? "}" : "]");
}

Json StreamsJson(const Sequence& s) {
  Json streams;
  streams["color"] = ToJson(s.color, kRenderGridName);
  if (s.depth) streams["depth"] = ToJson(*s.depth, kRenderGridName);
  if (s.motion) streams["motion"] = ToJson(*s.motion, kRenderGridName);
  if (s.reference) streams["reference"] = ToJson(*s.reference, kOutputGridName);
  if (s.reference_depth) streams["reference_depth"] = ToJson(*s.reference_depth, kOutputGridName);
  if (s.reference_motion)
    streams["reference_motion"] = ToJson(*s.reference_motion, kOutputGridName);
  if (s.reactive) streams["reactive"] = ToJson(*s.reactive);
  if (s.hud) streams["hud"] = ToJson(*s.hud);
  if (s.alpha) streams["alpha"] = ToJson(*s.alpha, kRenderGridName);
  if (s.reference_alpha) streams["reference_alpha"] = ToJson(*s.reference_alpha, kOutputGridName);
  return streams;
}

}  // namespace

std::string SequenceJson(const Sequence& s) {
  if (std::string why; !s.IsValid(&why)) {
    throw Error(fmt::format("the sequence '{}' cannot be written: {}", s.name, why));
  }
  std::string text = "{";
  const char* separator = "\n ";
  const auto add = [&](const char* field, const std::string& value) {
    text += fmt::format("{}\"{}\": {}", separator, field, value);
    separator = ",\n ";
  };
  const auto size = [](GridSize g) {
    return JsonText(Json{{"width", g.width}, {"height", g.height}});
  };
  add("format", JsonText(Json(Sequence::kFormat)));
  add("version", std::to_string(s.UsesVersion2() ? Sequence::kLatestVersion : Sequence::kVersion));
  add("name", JsonText(Json(s.name)));
  add("frames", JsonText(s.numbers.empty() ? Json{{"first", s.first}, {"count", s.count}}
                                           : Json{{"numbers", s.numbers}}));
  add("render", size(s.render));
  add("output", size(s.output));
  if (!s.render_sizes.empty()) {
    Json sizes = Json::array();
    for (const GridSize& g : s.render_sizes) sizes.push_back({g.width, g.height});
    add("render_sizes", JsonText(sizes));
  }
  add("color_space", JsonText(Json(NameOf(kColorSpaces, s.color_space))));
  if (!s.exposures.empty()) add("exposures", JsonText(Json(s.exposures)));
  add("streams", Lines(StreamsJson(s)));
  if (!s.jitter.empty()) {
    Json offsets = Json::array();
    for (const Vec2& v : s.jitter) offsets.push_back({v.x, v.y});
    add("jitter", Lines({{"units", kJitterUnitsName},
                         {"y", NameOf(kYAxes, YAxis::kDown)},
                         {"offsets", offsets}}));
  }
  if (!s.camera.empty()) {
    Json cameras = Json::array();
    for (const Camera& c : s.camera)
      cameras.push_back({{"view", c.view}, {"projection", c.projection}});
    add("camera", Lines(cameras));
  }
  add("cuts", JsonText(Json(s.cuts)));
  return text + "\n}\n";
}

}  // namespace warplut
