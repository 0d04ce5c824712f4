// sequence.json: Sequence from text.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/json_fields.h"
#include "datasets/sequence/sequence_names.h"

namespace warplut {
namespace {

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

// The fields that images of colour, masks and layers share.
template <typename Stream>
Stream TakeImage(JsonFields& fields, const char* grid) {
  Stream stream;
  stream.path = fields.Text("path");
  TakeFixed(fields, "grid", grid);
  stream.channels = TakeChannels(fields);
  return stream;
}

ColorStream TakeColor(JsonFields fields, const char* grid) {
  auto stream = TakeImage<ColorStream>(fields, grid);
  fields.Finish();
  return stream;
}

MaskStream TakeMask(JsonFields fields) {
  auto stream = TakeImage<MaskStream>(fields, kRenderGridName);
  fields.Finish();
  return stream;
}

AlphaStream TakeAlpha(JsonFields fields, const char* grid) {
  auto stream = TakeImage<AlphaStream>(fields, grid);
  stream.color = fields.OneOf("color", kAlphaKinds);
  fields.Finish();
  return stream;
}

LayerStream TakeLayer(JsonFields fields) {
  auto stream = TakeImage<LayerStream>(fields, kOutputGridName);
  stream.alpha = fields.OneOf("alpha", kAlphaKinds);
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
  s->color = TakeColor(fields.Object("color"), kRenderGridName);
  if (fields.Has("depth")) s->depth = TakeDepth(fields.Object("depth"), kRenderGridName);
  if (fields.Has("motion")) s->motion = TakeMotion(fields.Object("motion"), kRenderGridName);
  if (fields.Has("reference"))
    s->reference = TakeColor(fields.Object("reference"), kOutputGridName);
  if (fields.Has("reference_depth")) {
    s->reference_depth = TakeDepth(fields.Object("reference_depth"), kOutputGridName);
  }
  if (fields.Has("reference_motion")) {
    s->reference_motion = TakeMotion(fields.Object("reference_motion"), kOutputGridName);
  }
  if (fields.Has("reactive")) s->reactive = TakeMask(fields.Object("reactive"));
  if (fields.Has("hud")) s->hud = TakeLayer(fields.Object("hud"));
  if (fields.Has("alpha")) s->alpha = TakeAlpha(fields.Object("alpha"), kRenderGridName);
  if (fields.Has("reference_alpha")) {
    s->reference_alpha = TakeAlpha(fields.Object("reference_alpha"), kOutputGridName);
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

std::vector<GridSize> TakeRenderSizes(const nlohmann::json& value, const JsonPlace& at) {
  std::vector<GridSize> sizes;
  for (const auto& element : at.Array(value)) {
    const JsonPlace here = at.Element(sizes.size());
    const auto& size = here.Array(element, 2);
    sizes.push_back({here.Integer(size[0]), here.Integer(size[1])});
  }
  if (sizes.empty()) at.Fail("has no values; expected one for each frame, or no such field");
  return sizes;
}

std::vector<Vec2> TakeJitter(JsonFields fields) {
  TakeFixed(fields, "units", kJitterUnitsName);
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

std::vector<double> TakeExposures(const nlohmann::json& value, const JsonPlace& at) {
  std::vector<double> exposures;
  for (const auto& element : at.Array(value)) {
    exposures.push_back(at.Element(exposures.size()).Number(element));
  }
  if (exposures.empty()) at.Fail("has no values; expected one for each frame, or no such field");
  return exposures;
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

// How many folders `folder` lies below `above`, 0 if they are the same. Links are followed.
int LevelsBelow(const std::filesystem::path& folder, const std::filesystem::path& above) {
  std::error_code error;
  const auto inner = std::filesystem::canonical(folder.empty() ? "." : folder, error);
  const auto outer = error ? inner : std::filesystem::canonical(above, error);
  if (error || !std::filesystem::is_directory(outer)) {
    throw Error(fmt::format("'{}' is no folder that streams can lie below", above.string()));
  }
  const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  if (end != outer.end()) {
    throw Error(fmt::format("'{}' does not lie below '{}', the folder of the streams",
                            folder.string(), above.string()));
  }
  return static_cast<int>(std::distance(rest, inner.end()));
}

}  // namespace

Sequence ReadSequence(const std::filesystem::path& path,
                      const std::filesystem::path& streams_below) {
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
  if (!streams_below.empty()) s.levels_up = LevelsBelow(s.folder, streams_below);
  s.name = root.Text("name");
  TakeNumbers(root.Object("frames"), &s);
  s.render = TakeGrid(root, "render");
  s.output = TakeGrid(root, "output");
  if (root.Has("render_sizes")) {
    s.render_sizes = TakeRenderSizes(root.Take("render_sizes"), root.At("render_sizes"));
  }
  s.color_space = root.OneOf("color_space", kColorSpaces);
  if (root.Has("exposures")) {
    s.exposures = TakeExposures(root.Take("exposures"), root.At("exposures"));
  }
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

}  // namespace warplut
