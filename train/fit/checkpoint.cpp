#include "train/fit/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"
#include "datasets/file.h"
#include "luts/fit/json_header.h"

namespace warplut {
namespace {

constexpr const char* kFormat = "warplut-checkpoint";
constexpr int kVersion = 2;

// `length` of them, or 0.
std::vector<double> Numbers(JsonFields& fields, const char* name, std::size_t length,
                            bool may_be_empty = false) {
  const nlohmann::json& array = fields.Take(name);
  const JsonPlace place = fields.At(name);
  if (!(may_be_empty && array.is_array() && array.empty())) place.Array(array, length);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < array.size(); ++i) {
    numbers.push_back(place.Element(i).Number(array[i]));
  }
  return numbers;
}

// An option as a sentence has it.
std::string OptionText(const nlohmann::json& options, const std::string& name) {
  return options.contains(name) ? JsonText(options[name]) : "not set";
}

// The first option that differs, but for the limit of time.
std::string OptionDifference(const std::string& there, const std::string& here) {
  nlohmann::json a = ParseJson(there, "options"), b = ParseJson(here, "options");
  nlohmann::json names = a;
  names.update(b);
  for (const auto& [name, value] : names.items()) {
    if (name == "max_seconds" || (a.contains(name) && b.contains(name) && a[name] == b[name])) {
      continue;
    }
    return fmt::format("{} is {} there and {} here", name, OptionText(a, name),
                       OptionText(b, name));
  }
  return "";
}

}  // namespace

std::string CheckpointIdentity::DifferenceFrom(const CheckpointIdentity& other) const {
  const std::string option = OptionDifference(other.options, options);
  if (!option.empty()) return option;
  for (std::size_t i = 0; i < std::min(images.size(), other.images.size()); ++i) {
    if (images[i].sha1 == other.images[i].sha1) continue;
    return fmt::format("image {} is {} there and {} here, of other content", i + 1,
                       other.images[i].name, images[i].name);
  }
  if (images.size() == other.images.size()) return "";
  return fmt::format("there are {} images there and {} here", other.images.size(), images.size());
}

void WriteCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  nlohmann::ordered_json loss = nlohmann::ordered_json::array();
  for (const FitLoss& point : checkpoint.loss) {
    loss.push_back({point.seconds, point.evaluations, point.loss, point.validation});
  }
  nlohmann::ordered_json images = nlohmann::ordered_json::array();
  for (const auto& image : checkpoint.made_for.images) {
    images.push_back(nlohmann::ordered_json::array({image.name, image.sha1}));
  }
  nlohmann::ordered_json begun = nlohmann::ordered_json::array();
  for (const Evaluation& evaluation : checkpoint.begun) {
    begun.push_back({{"value", evaluation.value}, {"gradient", evaluation.gradient}});
  }
  const nlohmann::ordered_json json = {{"format", kFormat},
                                       {"version", kVersion},
                                       {"options", checkpoint.made_for.options},
                                       {"images", images},
                                       {"stage", checkpoint.stage},
                                       {"seconds", checkpoint.seconds},
                                       {"evaluations", checkpoint.evaluations},
                                       {"parameters", checkpoint.parameters},
                                       {"best_parameters", checkpoint.best_parameters},
                                       {"best_validation", checkpoint.best_validation},
                                       {"adam_step", checkpoint.adam.step},
                                       {"adam_mean", checkpoint.adam.mean},
                                       {"adam_variance", checkpoint.adam.variance},
                                       {"loss", loss},
                                       {"begun", begun}};
  WriteFile(path, JsonText(json, 1) + "\n");
}

Checkpoint ReadCheckpoint(const std::filesystem::path& path, const CheckpointIdentity& made_for,
                          std::size_t parameters) {
  const nlohmann::json json = ReadJson(path, kMaxCheckpointBytes);
  JsonFields fields(json, JsonPlace(path.string(), ""));
  CheckHeader(fields, kFormat, kVersion);
  Checkpoint checkpoint;
  checkpoint.made_for.options = fields.Text("options");
  if (!ParseJson(checkpoint.made_for.options, path.string()).is_object()) {
    fields.At("options").Fail("is no JSON object; expected the options of a training");
  }
  const JsonPlace images = fields.At("images");
  for (const nlohmann::json& image : images.Array(fields.Take("images"))) {
    const JsonPlace at = images.Element(checkpoint.made_for.images.size());
    at.Array(image, 2);
    checkpoint.made_for.images.push_back(
        {at.Element(0).Text(image[0]), at.Element(1).Text(image[1])});
  }
  if (const std::string difference = made_for.DifferenceFrom(checkpoint.made_for);
      !difference.empty()) {
    throw Error(fmt::format("{} was made by another training: {}.", path.string(), difference));
  }
  checkpoint.stage = fields.Integer("stage");
  checkpoint.seconds = fields.Number("seconds");
  checkpoint.evaluations = fields.Integer("evaluations");
  checkpoint.parameters = Numbers(fields, "parameters", parameters);
  checkpoint.best_parameters = Numbers(fields, "best_parameters", parameters, true);
  checkpoint.best_validation = fields.Number("best_validation");
  checkpoint.adam.step = fields.Integer("adam_step");
  checkpoint.adam.mean = Numbers(fields, "adam_mean", parameters, true);
  checkpoint.adam.variance = Numbers(fields, "adam_variance", parameters, true);
  const nlohmann::json& loss = fields.Take("loss");
  const JsonPlace place = fields.At("loss");
  place.Array(loss);
  for (std::size_t i = 0; i < loss.size(); ++i) {
    const JsonPlace point = place.Element(i);
    const nlohmann::json& values = point.Array(loss[i], 4);
    checkpoint.loss.push_back(
        {point.Element(0).Number(values[0]), point.Element(1).Integer(values[1]),
         point.Element(2).Number(values[2]), point.Element(3).Number(values[3])});
  }
  const JsonPlace begun = fields.At("begun");
  for (const nlohmann::json& value : begun.Array(fields.Take("begun"))) {
    JsonFields evaluation(value, begun.Element(checkpoint.begun.size()));
    checkpoint.begun.push_back(
        {evaluation.Number("value"), Numbers(evaluation, "gradient", parameters, true)});
    evaluation.Finish();
  }
  fields.Finish();
  return checkpoint;
}

}  // namespace warplut
