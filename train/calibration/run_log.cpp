#include "train/calibration/run_log.h"

#include <fmt/format.h>

#include <utility>

#include "datasets/file.h"
#include "luts/fit/json_header.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

constexpr const char* kFormat = "warplut-calibration-checkpoint";
constexpr int kVersion = 1;
constexpr double kSaveSeconds = 2;  // at most this much is lost when the process is killed

}  // namespace

RunLog::RunLog(ResidualFunction& function, RunLogOptions options)
    : function_(function),
      options_(std::move(options)),
      start_(Clock::now()),
      limit_(options_.max_seconds) {
  if (options_.resume && std::filesystem::exists(options_.checkpoint)) {
    Load();
    CheckThatRunsRepeat();
  }
}

const std::vector<double>* RunLog::Residuals(const Parameters& parameters, float gate_width) {
  Key key;
  for (std::size_t i = 0; i < kParameters.size(); ++i) key[i] = parameters.*kParameters[i].member;
  key.back() = gate_width;
  if (const auto known = runs_.find(key); known != runs_.end()) return &known->second;

  Ranks& ranks = Ranks::World();
  if (stop_ == Stop::kNone && ranks.Any(options_.go_on && !options_.go_on())) {
    stop_ = Stop::kAsked;
  }
  if (stop_ == Stop::kNone && limit_ > 0 && ranks.OfRoot(Seconds()) > limit_) {
    stop_ = Stop::kTime;
  }
  if (stop_ != Stop::kNone) return nullptr;

  std::vector<double> residuals(function_.Size());
  function_.Evaluate(parameters, gate_width, residuals);
  const auto added = runs_.emplace(key, std::move(residuals)).first;
  if (!saved_ || std::chrono::duration<double>(Clock::now() - *saved_).count() > kSaveSeconds) {
    Save();
  }
  return &added->second;
}

std::optional<double> RunLog::Loss(const Parameters& parameters, float gate_width) {
  const std::vector<double>* residuals = Residuals(parameters, gate_width);
  return residuals == nullptr ? std::nullopt : std::optional(LossOf(*residuals));
}

void RunLog::LimitTo(double max_seconds) {
  limit_ = max_seconds;
  if (stop_ == Stop::kTime && (limit_ == 0 || Ranks::World().OfRoot(Seconds()) <= limit_))
    stop_ = Stop::kNone;
}

double RunLog::Seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void RunLog::Save() {
  if (options_.checkpoint.empty() || !Ranks::World().IsRoot()) return;
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const auto& [key, residuals] : runs_) {
    runs.push_back({{"at", key}, {"residuals", residuals}});
  }
  const nlohmann::ordered_json json = {{"format", kFormat},
                                       {"version", kVersion},
                                       {"made_for", options_.made_for},
                                       {"runs", std::move(runs)}};
  WriteFile(options_.checkpoint, JsonText(json) + "\n");
  saved_ = Clock::now();
}

void RunLog::Load() {
  const std::string file = options_.checkpoint.string();
  const nlohmann::json json = ReadJson(options_.checkpoint, kMaxCheckpointBytes);
  JsonFields fields(json, JsonPlace(file, ""));
  CheckHeader(fields, kFormat, kVersion);
  if (fields.Text("made_for") != options_.made_for) {
    throw Error(
        fmt::format("{} was made by a calibration with other options or clips; expected a "
                    "checkpoint of this one.",
                    file));
  }
  const JsonPlace place = fields.At("runs");
  const nlohmann::json& runs = place.Array(fields.Take("runs"));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    JsonFields run(runs[i], place.Element(i));
    Key key;
    const nlohmann::json& at = run.At("at").Array(run.Take("at"), key.size());
    for (std::size_t k = 0; k < key.size(); ++k) {
      key[k] = static_cast<float>(run.At("at").Element(k).Number(at[k]));
    }
    const nlohmann::json& values =
        run.At("residuals").Array(run.Take("residuals"), function_.Size());
    std::vector<double> residuals;
    for (std::size_t k = 0; k < values.size(); ++k) {
      residuals.push_back(run.At("residuals").Element(k).Number(values[k]));
    }
    run.Finish();
    runs_.emplace(key, std::move(residuals));
  }
  fields.Finish();
}

void RunLog::CheckThatRunsRepeat() {
  if (runs_.empty()) return;
  const auto& [key, residuals] = *runs_.begin();
  Parameters parameters;
  for (std::size_t i = 0; i < kParameters.size(); ++i) parameters.*kParameters[i].member = key[i];
  std::string why;
  if (!parameters.IsValid(&why)) {
    throw Error(fmt::format("{} holds a run whose {}", options_.checkpoint.string(), why));
  }
  std::vector<double> again(residuals.size());
  function_.Evaluate(parameters, key.back(), again);
  if (again != residuals) {
    throw Error(fmt::format(
        "the runs in {} do not repeat: the frames or the program have changed since; expected the "
        "same, or no --resume.",
        options_.checkpoint.string()));
  }
}

}  // namespace warplut
