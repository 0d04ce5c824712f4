#include "luts/bake/test_vectors.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "luts/fit/json_header.h"
#include "luts/fit/prefilter_json.h"

namespace warplut {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::array<float, 2>> Offsets() {
  std::vector<std::array<float, 2>> offsets = {
      {0, 0},      {0.5f, 0},     {0, 0.5f},          {0.5f, 0.5f},
      {0.25f, 0},  {0.75f, 0.5f}, {31 / 32.0f, 0.5f}, {1 / 64.0f, 63 / 64.0f},
      {0.1f, 0.9f}};
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  while (offsets.size() < 24) {
    const float dx = number();
    offsets.push_back({dx, number()});
  }
  return offsets;
}

Json Numbers(const auto& numbers) {
  Json list = Json::array();
  for (const float number : numbers) list.push_back(static_cast<double>(number));
  return list;
}

}  // namespace

std::string TestVectors(const std::string& name, const Table& table) {
  Json json;
  json["format"] = "warplut-test-vectors";
  json["version"] = 1;
  json["name"] = name;
  json["taps"] = TapCount(table.footprint());
  if (HasPrefilter(table.prefilter())) json["prefilter"] = ToJson(table.prefilter());
  std::string text = JsonText(json, 1);
  text.resize(text.rfind("\n}"));
  text += ",\n \"vectors\": [\n";
  std::mt19937 random(2);
  const std::vector<std::array<float, 2>> offsets = Offsets();
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    std::array<float, kWeights> patch;
    for (float& texel : patch) texel = static_cast<float>(random() % 256) / 256;
    Json vector;
    vector["offset"] = Numbers(offsets[v]);
    vector["patch"] = Numbers(patch);
    for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
      const Weights<float> weights = table.At(offsets[v][0], offsets[v][1], lookup);
      std::vector<float> stored;
      double value = 0;
      for (const int k : TapsOf(table.footprint())) {
        stored.push_back(weights[k]);
        value += static_cast<double>(weights[k]) * static_cast<double>(patch[k]);
      }
      vector[Name(lookup)] = {{"weights", Numbers(stored)}, {"value", value}};
    }
    text += "  " + vector.dump() + (v + 1 < offsets.size() ? ",\n" : "\n");
  }
  return text + " ]\n}\n";
}

}  // namespace warplut
