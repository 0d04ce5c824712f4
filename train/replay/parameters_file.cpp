#include "train/replay/parameters_file.h"

#include <fmt/format.h>

#include <cstdlib>

#include "luts/fit/json_header.h"

namespace warplut {
namespace {

// The double with the fewest digits that is still this float.
double ShortestDouble(float value) {
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

}  // namespace

Parameters ReadParameters(const std::filesystem::path& path) {
  const nlohmann::json json = ReadJson(path);
  JsonFields fields(json, JsonPlace(path.string(), ""));
  CheckHeader(fields, kParametersFormat, kParametersVersion);
  const JsonPlace place = fields.At("parameters");
  const nlohmann::json& values = fields.Take("parameters");
  if (!values.is_object()) place.Refuse(values, "an object in { }");
  Parameters parameters;
  for (const auto& [name, value] : values.items()) {
    const JsonPlace at = place.Field(name);
    const int index = FindParameter(name);
    if (index < 0) at.Fail(fmt::format("is unknown; expected {}", ParameterNames()));
    const ParameterInfo& info = kParameters[index];
    const auto number = static_cast<float>(at.Number(value));
    if (!(number >= info.min && number <= info.max)) {
      at.Refuse(value, fmt::format("{:g} to {:g}", info.min, info.max));
    }
    parameters.*info.member = number;
  }
  if (fields.Has("calibration")) fields.Take("calibration");
  fields.Finish();
  return parameters;
}

std::string ParametersJson(const Parameters& parameters, const std::string& calibration_json) {
  std::string why;
  if (!parameters.IsValid(&why)) throw Error(why);
  nlohmann::ordered_json json = {{"format", kParametersFormat}, {"version", kParametersVersion}};
  for (const ParameterInfo& info : kParameters) {
    json["parameters"][info.name] = ShortestDouble(parameters.*info.member);
  }
  if (!calibration_json.empty()) {
    const auto report = nlohmann::ordered_json::parse(calibration_json, nullptr, false);
    if (!report.is_object()) {
      throw Error(fmt::format("the calibration's report is '{}'; expected a JSON object.",
                              calibration_json.substr(0, 60)));
    }
    json["calibration"] = report;
  }
  return JsonText(json, 2) + "\n";
}

}  // namespace warplut
