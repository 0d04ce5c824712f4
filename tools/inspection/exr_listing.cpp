#include "tools/inspection/exr_listing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/json_fields.h"
#include "tools/tables/record_table.h"

namespace warplut {
namespace {

// Channels with the same text before their last dot.
struct Layer {
  std::string prefix;
  std::vector<std::string> names;  // the rest: "R", "Z", ...
};

std::vector<Layer> Layers(const std::vector<std::string>& channels) {
  std::vector<Layer> layers;
  for (const std::string& channel : channels) {
    const auto dot = channel.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : channel.substr(0, dot + 1);
    const std::string name = dot == std::string::npos ? channel : channel.substr(dot + 1);
    const auto at = std::find_if(layers.begin(), layers.end(),
                                 [&](const Layer& layer) { return layer.prefix == prefix; });
    if (at == layers.end()) {
      layers.push_back({prefix, {name}});
    } else {
      at->names.push_back(name);
    }
  }
  return layers;
}

bool Has(const Layer& layer, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(layer.names.begin(), layer.names.end(), name) != layer.names.end();
  });
}

// The manifest's text of a stream with these channels of the layer.
Json Stream(const std::string& file, const std::string& part, const Layer& layer,
            const std::vector<std::string>& names, Json more) {
  Json channels = Json::array();
  for (const std::string& name : names) {
    channels.push_back((part.empty() ? "" : part + ".") + layer.prefix + name);
  }
  Json stream = {{"path", file}, {"grid", "render"}, {"channels", channels}};
  for (const auto& [key, value] : more.items()) stream[key] = value;
  return stream;
}

const Json kMotion = {{"units", "pixels"}, {"direction", "previous-to-current"}, {"y", "down"}};

Json StreamsOf(const std::string& file, const std::string& part, const Layer& layer) {
  Json streams = Json::object();
  if (Has(layer, {"R", "G", "B"}))
    streams["color"] = Stream(file, part, layer, {"R", "G", "B"}, {});
  if (Has(layer, {"Z"}) && !Has(layer, {"X"})) {
    streams["depth"] =
        Stream(file, part, layer, {"Z"}, {{"kind", "linear"}, {"near", 0}, {"far", 1000}});
  }
  // Blender's vector pass: X, Y to the previous frame, Z, W to the next, pixels, y up.
  if (Has(layer, {"X", "Y", "Z", "W"})) {
    streams["motion"] =
        Stream(file, part, layer, {"X", "Y"},
               {{"units", "pixels"}, {"direction", "current-to-previous"}, {"y", "up"}});
  } else if (Has(layer, {"X", "Y"})) {
    streams["motion"] = Stream(file, part, layer, {"X", "Y"}, kMotion);
  }
  return streams;
}

}  // namespace

bool IsImageToList(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && !HasExtension(path, ".json");
}

Json ExrListing(const std::filesystem::path& path) {
  Json parts = Json::array();
  const std::string file = path.filename().string();
  const std::vector<ImagePart> read = ReadImageParts(path);
  for (const ImagePart& part : read) {
    Json channels = Json::array(), streams = Json::array();
    for (std::size_t c = 0; c < part.channels.size(); ++c) {
      channels.push_back({{"name", part.channels[c]}, {"type", part.types[c]}});
    }
    for (const Layer& layer : Layers(part.channels)) {
      const std::string name = read.size() > 1 ? part.name : "";
      const Json found = StreamsOf(file, name, layer);
      for (const auto& [stream, value] : found.items()) {
        streams.push_back({{"stream", stream}, {"value", value}});
      }
    }
    parts.push_back({{"name", part.name},
                     {"width", part.width},
                     {"height", part.height},
                     {"channels", channels},
                     {"streams", streams}});
  }
  return {{"file", path.string()}, {"parts", parts}};
}

std::string ExrListingText(const Json& listing) {
  std::string text;
  int number = 0;
  for (const Json& part : listing["parts"]) {
    text += fmt::format("part {}{}: {} x {}\n", number++,
                        part["name"].get<std::string>().empty()
                            ? ""
                            : fmt::format(" \"{}\"", part["name"].get<std::string>()),
                        part["width"].get<int>(), part["height"].get<int>());
    TextTable table{.header = {"  channel", "type"}, .rows = {}};
    for (const Json& channel : part["channels"]) {
      table.rows.push_back(
          {"  " + channel["name"].get<std::string>(), channel["type"].get<std::string>()});
    }
    text += ToText(table);
    for (const Json& stream : part["streams"]) {
      text += fmt::format("  \"{}\": {}\n", stream["stream"].get<std::string>(),
                          JsonText(stream["value"]));
    }
  }
  text += "Paths are those of this file: put %04d in place of the frame's number.\n";
  return text;
}

}  // namespace warplut
