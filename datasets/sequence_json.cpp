// sequence.json: Sequence from and to text.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/json_fields.h"
#include "datasets/sequence.h"

namespace warplut {
namespace {

using Json = nlohmann::ordered_json;
template <class T, std::size_t n>
using Names = std::array<std::pair<T, const char*>, n>;

constexpr Names<ColorSpace, 2> kColorSpaces{
    {{ColorSpace::kSrgb, "srgb"}, {ColorSpace::kLinear, "linear"}}};
constexpr Names<Encoding, 2> kEncodings{
    {{Encoding::kFloat, "float"}, {Encoding::kRgba8Base255, "rgba8-base255"}}};
constexpr Names<DepthKind, 3> kDepthKinds{{{DepthKind::kLinear, "linear"},
                                           {DepthKind::kForward, "forward"},
                                           {DepthKind::kReversed, "reversed"}}};
constexpr Names<MotionUnits, 3> kMotionUnits{
    {{MotionUnits::kPixels, "pixels"}, {MotionUnits::kUv, "uv"}, {MotionUnits::kNdc, "ndc"}}};
constexpr Names<MotionDirection, 3> kDirections{
    {{MotionDirection::kPreviousToCurrent, "previous-to-current"},
     {MotionDirection::kCurrentToPrevious, "current-to-previous"},
     {MotionDirection::kCurrentToNext, "current-to-next"}}};
constexpr Names<bool, 2> kJitterIn{{{false, "excluded"}, {true, "included"}}};
constexpr Names<YAxis, 2> kYAxes{{{YAxis::kDown, "down"}, {YAxis::kUp, "up"}}};

constexpr const char* kRenderGrid = "render";
constexpr const char* kOutputGrid = "output";
constexpr const char* kJitterUnits = "render-pixels";

template <class T, std::size_t n>
const char* NameOf(const Names<T, n>& names, T value) {
  for (const auto& [v, name] : names) {
    if (v == value) return name;
  }
  return "";
}

// A field of which version 1 knows one value.
void TakeFixed(JsonFields& fields, const char* name, const char* value) {
  const std::string found = fields.Text(name);
  if (found != value) fields.At(name).Refuse(found, fmt::format("\"{}\"", value));
}

GridSize TakeGrid(JsonFields& root, const char* name) {
  JsonFields fields = root.Object(name);
  const GridSize size{fields.Integer("width"), fields.Integer("height")};
  fields.Finish();
  return size;
}

std::vector<std::string> TakeChannels(JsonFields& fields) {
  std::vector<std::string> channels;
  if (!fields.Has("channels")) return channels;
  const auto& names = fields.At("channels").Array(fields.Take("channels"));
  if (names.empty()) fields.At("channels").Fail("has no names; expected some, or no such field");
  for (std::size_t i = 0; i < names.size(); ++i) {
    channels.push_back(fields.At("channels").Element(i).Text(names[i]));
  }
  return channels;
}

Encoding TakeEncoding(JsonFields& fields) {
  return fields.Has("encoding") ? fields.OneOf("encoding", kEncodings) : Encoding::kFloat;
}

// A number, or one for each of x and y.
std::array<double, 2> TakePair(JsonFields& fields, const char* name, double otherwise) {
  if (!fields.Has(name)) return {otherwise, otherwise};
  const auto& value = fields.Take(name);
  if (value.is_number()) return {fields.Number(name), fields.Number(name)};
  const JsonPlace at = fields.At(name);
  at.Array(value, 2);
  return {at.Element(0).Number(value[0]), at.Element(1).Number(value[1])};
}

ColorStream TakeColor(JsonFields fields, const char* grid) {
  ColorStream stream;
  stream.path = fields.Text("path");
  TakeFixed(fields, "grid", grid);
  stream.channels = TakeChannels(fields);
  fields.Finish();
  return stream;
}

DepthStream TakeDepth(JsonFields fields, const char* grid) {
  DepthStream stream;
  stream.path = fields.Text("path");
  TakeFixed(fields, "grid", grid);
  stream.channels = TakeChannels(fields);
  stream.encoding = TakeEncoding(fields);
  if (fields.Has("scale")) stream.scale = fields.Number("scale");
  if (fields.Has("bias")) stream.bias = fields.Number("bias");
  stream.kind = fields.OneOf("kind", kDepthKinds);
  stream.near = fields.Number("near");
  stream.far =
      fields.Take("far").is_null() ? std::numeric_limits<double>::infinity() : fields.Number("far");
  if (fields.Has("background")) stream.background = fields.Number("background");
  fields.Finish();
  return stream;
}

// A number, numbers, or the channel that tells.
InvalidMotion TakeInvalid(JsonFields& fields) {
  InvalidMotion invalid;
  const auto& value = fields.Take("invalid");
  const JsonPlace at = fields.At("invalid");
  if (value.is_object()) {
    JsonFields object(value, at);
    invalid.channel = object.Text("channel");
    if (invalid.channel.empty()) object.At("channel").Fail("is empty; expected a channel's name");
    object.Finish();
  } else if (value.is_number()) {
    invalid.values = {at.Number(value)};
  } else if (value.is_array()) {
    for (const auto& element : value) {
      invalid.values.push_back(at.Element(invalid.values.size()).Number(element));
    }
  } else {
    at.Refuse(value, "a number, numbers in [ ] or {\"channel\": NAME}");
  }
  return invalid;
}

MotionStream TakeMotion(JsonFields fields, const char* grid) {
  MotionStream stream;
  if (fields.Has("path_x") || fields.Has("path_y")) {
    stream.path_x = fields.Text("path_x");
    stream.path_y = fields.Text("path_y");
    if (fields.Has("path")) stream.path = fields.Text("path");
  } else {
    stream.path = fields.Text("path");
  }
  TakeFixed(fields, "grid", grid);
  stream.channels = TakeChannels(fields);
  stream.encoding = TakeEncoding(fields);
  stream.scale = TakePair(fields, "scale", 1);
  stream.bias = TakePair(fields, "bias", 0);
  stream.units = fields.OneOf("units", kMotionUnits);
  stream.direction = fields.OneOf("direction", kDirections);
  stream.y = fields.OneOf("y", kYAxes);
  if (fields.Has("invalid")) stream.invalid = TakeInvalid(fields);
  if (fields.Has("frame_offset")) stream.frame_offset = fields.Integer("frame_offset");
  if (fields.Has("jitter")) stream.contains_jitter = fields.OneOf("jitter", kJitterIn);
  fields.Finish();
  return stream;
}

void TakeStreams(JsonFields fields, Sequence* s) {
  s->color = TakeColor(fields.Object("color"), kRenderGrid);
  if (fields.Has("depth")) s->depth = TakeDepth(fields.Object("depth"), kRenderGrid);
  if (fields.Has("motion")) s->motion = TakeMotion(fields.Object("motion"), kRenderGrid);
  if (fields.Has("reference")) s->reference = TakeColor(fields.Object("reference"), kOutputGrid);
  if (fields.Has("reference_depth")) {
    s->reference_depth = TakeDepth(fields.Object("reference_depth"), kOutputGrid);
  }
  if (fields.Has("reference_motion")) {
    s->reference_motion = TakeMotion(fields.Object("reference_motion"), kOutputGrid);
  }
  fields.Finish();
}

// `first` and `count`, or `numbers` with gaps.
void TakeNumbers(JsonFields fields, Sequence* s) {
  if (!fields.Has("numbers")) {
    s->first = fields.Integer("first");
    s->count = fields.Integer("count");
  } else {
    const JsonPlace at = fields.At("numbers");
    for (const auto& number : at.Array(fields.Take("numbers"))) {
      s->numbers.push_back(at.Element(s->numbers.size()).Integer(number));
    }
    if (s->numbers.empty()) at.Fail("has no values; expected the number of each frame");
    s->first = s->numbers.front();
    s->count = static_cast<int>(s->numbers.size());
  }
  fields.Finish();
}

std::vector<Vec2> TakeJitter(JsonFields fields) {
  TakeFixed(fields, "units", kJitterUnits);
  const double sign = fields.OneOf("y", kYAxes) == YAxis::kDown ? 1 : -1;
  const JsonPlace at = fields.At("offsets");
  const auto& offsets = at.Array(fields.Take("offsets"));
  if (offsets.empty()) at.Fail("has no values; expected at least one, or no field 'jitter'");
  std::vector<Vec2> jitter;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const JsonPlace here = at.Element(i);
    const auto& offset = here.Array(offsets[i], 2);
    jitter.push_back({here.Number(offset[0]), sign * here.Number(offset[1])});
  }
  fields.Finish();
  return jitter;
}

std::array<double, 16> TakeMatrix(JsonFields& fields, const char* name) {
  std::array<double, 16> matrix;
  const auto& values = fields.At(name).Array(fields.Take(name), matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    matrix[i] = fields.At(name).Element(i).Number(values[i]);
  return matrix;
}

std::vector<Camera> TakeCamera(const nlohmann::json& value, const JsonPlace& at) {
  std::vector<Camera> cameras;
  for (const auto& element : at.Array(value)) {
    JsonFields fields(element, at.Element(cameras.size()));
    cameras.push_back({TakeMatrix(fields, "view"), TakeMatrix(fields, "projection")});
    fields.Finish();
  }
  return cameras;
}

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
  streams["color"] = ToJson(s.color, kRenderGrid);
  if (s.depth) streams["depth"] = ToJson(*s.depth, kRenderGrid);
  if (s.motion) streams["motion"] = ToJson(*s.motion, kRenderGrid);
  if (s.reference) streams["reference"] = ToJson(*s.reference, kOutputGrid);
  if (s.reference_depth) streams["reference_depth"] = ToJson(*s.reference_depth, kOutputGrid);
  if (s.reference_motion) streams["reference_motion"] = ToJson(*s.reference_motion, kOutputGrid);
  return streams;
}

}  // namespace

std::vector<std::filesystem::path> SequencesBelow(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> folders;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (std::filesystem::exists(it->path() / Sequence::kManifest)) folders.push_back(it->path());
  }
  if (error) throw Error(fmt::format("cannot list '{}': {}", folder.string(), error.message()));
  std::sort(folders.begin(), folders.end(),
            [](const auto& a, const auto& b) { return a.native() < b.native(); });
  return folders;
}

namespace {

// A folder of sequences in place of one is a slip that the names below it can mend.
void RequireManifest(const std::filesystem::path& folder, const std::filesystem::path& manifest) {
  if (std::filesystem::exists(manifest)) return;
  const auto below = SequencesBelow(folder);
  if (below.empty()) return;
  std::string names;
  for (const auto& sequence : below) {
    names += (names.empty() ? "" : ", ") + sequence.filename().string();
  }
  throw Error(fmt::format("'{}' has no {}; expected one of the sequences below it: {}",
                          folder.string(), Sequence::kManifest, names));
}

}  // namespace

Sequence ReadSequence(const std::filesystem::path& path) {
  const auto manifest = std::filesystem::is_directory(path) ? path / Sequence::kManifest : path;
  if (manifest != path) RequireManifest(path, manifest);
  const std::string file = manifest.string();
  const nlohmann::json parsed = ReadJson(manifest, kMaxManifestBytes);

  JsonFields root(parsed, JsonPlace(file, ""));
  TakeFixed(root, "format", Sequence::kFormat);
  const int version = root.Integer("version");
  if (version != 1 && version != 2) root.At("version").Refuse(version, "1 or 2");
  Sequence s;
  s.folder = manifest.parent_path();
  s.name = root.Text("name");
  TakeNumbers(root.Object("frames"), &s);
  s.render = TakeGrid(root, "render");
  s.output = TakeGrid(root, "output");
  s.color_space = root.OneOf("color_space", kColorSpaces);
  TakeStreams(root.Object("streams"), &s);
  if (root.Has("jitter")) s.jitter = TakeJitter(root.Object("jitter"));
  if (root.Has("camera")) {
    s.camera = TakeCamera(root.Take("camera"), root.At("camera"));
    if (s.camera.empty())
      root.At("camera").Fail("has no values; expected one for each frame, or no such field");
  }
  if (root.Has("cuts")) {
    for (const auto& cut : root.At("cuts").Array(root.Take("cuts"))) {
      s.cuts.push_back(root.At("cuts").Element(s.cuts.size()).Integer(cut));
    }
  }
  root.Finish();
  if (version == 1 && s.UsesVersion2())
    root.At("version").Fail("is 1, and the manifest has fields of version 2; expected 2");
  if (std::string why; !s.IsValid(&why)) throw Error(fmt::format("'{}': {}", file, why));
  return s;
}

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
  add("color_space", JsonText(Json(NameOf(kColorSpaces, s.color_space))));
  add("streams", Lines(StreamsJson(s)));
  if (!s.jitter.empty()) {
    Json offsets = Json::array();
    for (const Vec2& v : s.jitter) offsets.push_back({v.x, v.y});
    add("jitter",
        Lines(
            {{"units", kJitterUnits}, {"y", NameOf(kYAxes, YAxis::kDown)}, {"offsets", offsets}}));
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
