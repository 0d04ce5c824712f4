#include "train/fit/checkpoint.h"

#include <fmt/format.h>

#include "datasets/error.h"
#include "datasets/file.h"
#include "luts/fit/json_header.h"

namespace warplut {
namespace {

constexpr const char* kFormat = "warplut-checkpoint";
constexpr int kVersion = 1;

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

}  // namespace

void WriteCheckpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  nlohmann::ordered_json loss = nlohmann::ordered_json::array();
  for (const FitLoss& point : checkpoint.loss) {
    loss.push_back({point.seconds, point.evaluations, point.loss, point.validation});
  }
  const nlohmann::ordered_json json = {{"format", kFormat},
                                       {"version", kVersion},
                                       {"made_for", checkpoint.made_for},
                                       {"stage", checkpoint.stage},
                                       {"seconds", checkpoint.seconds},
                                       {"evaluations", checkpoint.evaluations},
                                       {"parameters", checkpoint.parameters},
                                       {"best_parameters", checkpoint.best_parameters},
                                       {"best_validation", checkpoint.best_validation},
                                       {"adam_step", checkpoint.adam.step},
                                       {"adam_mean", checkpoint.adam.mean},
                                       {"adam_variance", checkpoint.adam.variance},
                                       {"loss", loss}};
  WriteFile(path, JsonText(json, 1) + "\n");
}

Checkpoint ReadCheckpoint(const std::filesystem::path& path, const std::string& made_for,
                          std::size_t parameters) {
  const nlohmann::json json = ReadJson(path);
  JsonFields fields(json, JsonPlace(path.string(), ""));
  CheckHeader(fields, kFormat, kVersion);
  Checkpoint checkpoint;
  checkpoint.made_for = fields.Text("made_for");
  if (checkpoint.made_for != made_for) {
    throw Error(fmt::format(
        "{} was made by a training with other options or data; expected a checkpoint of this one.",
        path.string()));
  }
  checkpoint.stage = fields.Integer("stage");
  checkpoint.seconds = fields.Number("seconds");
  checkpoint.evaluations = fields.Integer("evaluations");
  checkpoint.parameters = Numbers(fields, "parameters", parameters);
  checkpoint.best_parameters = Numbers(fields, "best_parameters", parameters);
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
  fields.Finish();
  return checkpoint;
}

}  // namespace warplut
