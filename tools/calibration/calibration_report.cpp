#include "tools/calibration/calibration_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace warplut {
namespace {

const ParameterInfo& InfoOf(const CalibratedParameter& parameter) {
  return kParameters[static_cast<std::size_t>(parameter.parameter)];
}

Json ToJson(const Parameters& parameters) {
  Json json = Json::object();
  for (const ParameterInfo& info : kParameters) {
    json[info.name] = std::stod(fmt::format("{}", parameters.*info.member));
  }
  return json;
}

Json ToJson(const Candidate& candidate) {
  return {{"loss", candidate.loss}, {"parameters", ToJson(candidate.parameters)}};
}

const char* StopName(RunLog::Stop stop) {
  switch (stop) {
    case RunLog::Stop::kNone:
      return "done";
    case RunLog::Stop::kAsked:
      return "interrupted";
    case RunLog::Stop::kTime:
      return "time limit";
  }
  return "";
}

Json ToJson(const CalibratedParameter& parameter) {
  Json json = {{"name", InfoOf(parameter).name},
               {"value", parameter.value},
               {"optimum", parameter.optimum},
               {"at_default", parameter.at_base}};
  json["standard_error"] =
      parameter.standard_error ? Json(*parameter.standard_error) : Json(nullptr);
  if (parameter.profiled) json["needed"] = !parameter.NotNeeded();
  json["at_min"] = parameter.at_min;
  json["at_max"] = parameter.at_max;
  Json profile = Json::array();
  for (const ProfilePoint& point : parameter.profile.points) {
    profile.push_back({point.value, point.loss});
  }
  json["profile"] = std::move(profile);
  return json;
}

std::string Number(double value) { return fmt::format("{:.4g}", value); }

// Whether a time limit ended the search: its best point is no optimum then.
bool WasCut(const CalibrationResult& result) { return result.stop == RunLog::Stop::kTime; }

// A loss that may not have been computed.
std::string LossText(double loss) { return NumberCell(loss, 5).text; }

TextTable ParameterTable(const CalibrationResult& result) {
  TextTable table{.header = {"parameter", "kept", WasCut(result) ? "best so far" : "optimum", "+-",
                             "from", "to", "loss over range", "needed"},
                  .rows = {}};
  for (const CalibratedParameter& parameter : result.parameters) {
    const ParameterInfo& info = InfoOf(parameter);
    std::string needed = "?";
    if (parameter.profiled) needed = parameter.NotNeeded() ? "no" : "yes";
    table.rows.push_back({info.name, Number(parameter.value), Number(parameter.optimum),
                          parameter.standard_error ? Number(*parameter.standard_error) : "-",
                          Number(info.min), Number(info.max),
                          parameter.profiled ? LossText(parameter.profile.Spread()) : "-", needed});
  }
  return table;
}

TextTable CorrelationTable(const CalibrationResult& result) {
  TextTable table{.header = {"correlation"}, .rows = {}};
  const std::size_t size = result.parameters.size();
  for (std::size_t i = 0; i < size; ++i) {
    table.header.emplace_back(InfoOf(result.parameters[i]).name);
    std::vector<std::string> row = {InfoOf(result.parameters[i]).name};
    for (std::size_t j = 0; j <= i; ++j) {
      row.push_back(fmt::format("{:.2f}", result.correlations[i * size + j]));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

TextTable LossTable(const CalibrationReport& report) {
  TextTable table{.header = {"1 - SSIM", "calibrated", "default", "paper"}, .rows = {}};
  const auto add = [&](const std::string& name, bool held_out) {
    std::vector<std::string> row = {name};
    for (const auto at :
         {&CalibrationScore::calibrated, &CalibrationScore::defaults, &CalibrationScore::paper}) {
      row.push_back(fmt::format("{:.5f}", report.Loss(at, held_out)));
    }
    table.rows.push_back(std::move(row));
  };
  add("fitted", false);
  if (report.HoldsOut()) add("held out", true);
  for (const CalibrationScore& score : report.scores) {
    table.rows.push_back(
        {fmt::format("  {} {}{}", score.mode, score.clip, score.held_out ? ", held out" : ""),
         fmt::format("{:.5f}", 1 - score.calibrated), fmt::format("{:.5f}", 1 - score.defaults),
         fmt::format("{:.5f}", 1 - score.paper)});
  }
  return table;
}

TextTable StartTable(const CalibrationResult& result) {
  TextTable table{.header = {"start", "loss", "ends at", "optimum"}, .rows = {}};
  for (const CalibrationStart& start : result.starts) {
    std::string optimum = start.optimum < 0 ? "stuck" : fmt::format("{}", start.optimum + 1);
    if (!start.complete) optimum = "cut";
    table.rows.push_back(
        {start.name, LossText(start.from.loss), LossText(start.to.loss), std::move(optimum)});
  }
  return table;
}

// One line for each of the optima but the best.
std::string OtherOptima(const CalibrationResult& result) {
  std::string text;
  for (std::size_t i = 1; i < result.optima.size(); ++i) {
    text += fmt::format("optimum {} ({:.5f}):", i + 1, result.optima[i].loss);
    for (const CalibratedParameter& parameter : result.parameters) {
      const ParameterInfo& info = InfoOf(parameter);
      text += fmt::format(" {} {}", info.name, Number(result.optima[i].parameters.*info.member));
    }
    text += "\n";
  }
  return text;
}

// What a time limit left undone.
std::string CutSentence(const CalibrationResult& result) {
  const auto complete = std::count_if(result.starts.begin(), result.starts.end(),
                                      [](const CalibrationStart& s) { return s.complete; });
  const auto profiled =
      std::count_if(result.parameters.begin(), result.parameters.end(),
                    [](const CalibratedParameter& parameter) { return parameter.profiled; });
  return fmt::format(
      "The time limit ended the work: {} of {} starts and {} of {} profiles are complete{}. The "
      "best point so far need not be an optimum; --resume with a larger limit goes on.",
      complete, result.planned_starts, profiled, result.parameters.size(),
      result.correlations.empty() ? ", standard errors are not known" : "");
}

// What the search tells of its optima.
void AppendOptima(const CalibrationResult& result, std::vector<std::string>& sentences) {
  const auto reached = std::count_if(result.starts.begin(), result.starts.end(),
                                     [](const CalibrationStart& s) { return s.optimum == 0; });
  sentences.push_back(result.optima.size() > 1
                          ? fmt::format("There are {} optima; {} of {} starts reach the best one.",
                                        result.optima.size(), reached, result.starts.size())
                          : fmt::format("One optimum was found; {} of {} starts reach it.", reached,
                                        result.starts.size()));
  if (reached == 0 && !result.starts.empty()) {
    sentences.emplace_back(
        "A profile led to the best values, no start did: they may not be the best there are.");
  }
}

// What is kept, and why.
void AppendKept(const CalibrationResult& result, std::vector<std::string>& sentences) {
  if (!result.kept_error) {
    sentences.emplace_back(
        "Kept are the defaults: there was no time to judge how far the clips lead from them.");
    return;
  }
  for (const CalibratedParameter& parameter : result.parameters) {
    if (!parameter.at_base || parameter.value == parameter.optimum) continue;
    sentences.push_back(fmt::format("{} is kept at the default: the data does not tell{}.",
                                    InfoOf(parameter).name,
                                    WasCut(result) ? " it from the best point so far" : ""));
  }
  if (result.kept.parameters == result.best.parameters) return;
  sentences.push_back(fmt::format(
      "Kept is a point of loss {:.5f}, nearer to the defaults than the {} ({:.5f}): {:.5f} more, "
      "+- {:.5f}.",
      result.kept.loss, WasCut(result) ? "best one so far" : "optimum", result.best.loss,
      result.kept.loss - result.best.loss, *result.kept_error));
}

std::vector<std::string> Sentences(const CalibrationReport& report) {
  const CalibrationResult& result = report.result;
  std::vector<std::string> sentences;
  if (WasCut(result)) {
    sentences.push_back(CutSentence(result));
  } else {
    AppendOptima(result, sentences);
  }
  for (const CalibratedParameter& parameter : result.parameters) {
    const ParameterInfo& info = InfoOf(parameter);
    if (parameter.NotNeeded()) {
      sentences.push_back(fmt::format(
          "{} is not needed: over its whole range the loss changes by less than {:g}; what reads "
          "it ({}) is a candidate for being left out.",
          info.name, kFlatProfile, info.meaning));
    } else if (!WasCut(result) && (parameter.at_min || parameter.at_max)) {
      sentences.push_back(fmt::format("The optimum of {} is at the {} end of its range.", info.name,
                                      parameter.at_min ? "lower" : "upper"));
    }
  }
  AppendKept(result, sentences);
  if (!report.HoldsOut()) {
    sentences.emplace_back(
        "No clip is held out: nothing here says how the values do on other content (--hold-out, "
        "or --split-frames for a single clip).");
  } else if (report.Loss(&CalibrationScore::calibrated, true) >
             report.Loss(&CalibrationScore::paper, true)) {
    sentences.emplace_back("On the held-out clips the paper's constants are better.");
  } else if (report.Loss(&CalibrationScore::calibrated, true) >
             report.Loss(&CalibrationScore::defaults, true)) {
    sentences.emplace_back("On the held-out clips the defaults are better.");
  }
  return sentences;
}

}  // namespace

bool CalibrationReport::HoldsOut() const {
  return std::any_of(scores.begin(), scores.end(),
                     [](const CalibrationScore& score) { return score.held_out; });
}

double CalibrationReport::Loss(double CalibrationScore::*at, bool held_out) const {
  std::map<std::string, std::pair<double, int>> by_mode;
  for (const CalibrationScore& score : scores) {
    if (score.held_out != held_out) continue;
    auto& [sum, count] = by_mode[score.mode];
    sum += 1 - score.*at;
    ++count;
  }
  double total = 0;
  for (const auto& [mode, sum] : by_mode) total += sum.first / sum.second;
  return by_mode.empty() ? 0 : total / static_cast<double>(by_mode.size());
}

Json ToJson(const CalibrationReport& report) {
  const CalibrationResult& result = report.result;
  Json json = {{"modes", report.modes},
               {"filter", report.filter},
               {"every", report.every},
               {"max_pixels", report.max_pixels},
               {"seed", report.seed},
               {"ended", StopName(result.stop)},
               {"planned_starts", result.planned_starts},
               {"kept_is_judged", result.kept_error.has_value()},
               {"search_runs", result.search_runs},
               {"runs", result.runs}};
  const auto losses = [&](bool held_out) -> Json {
    return {{"calibrated", report.Loss(&CalibrationScore::calibrated, held_out)},
            {"default", report.Loss(&CalibrationScore::defaults, held_out)},
            {"paper", report.Loss(&CalibrationScore::paper, held_out)}};
  };
  json["loss"]["fitted"] = losses(false);
  if (report.HoldsOut()) json["loss"]["held_out"] = losses(true);
  json["loss"]["optimum"] = result.best.loss;
  json["loss"]["kept"] = result.kept.loss;
  json["loss"]["standard_error"] = result.kept_error ? Json(*result.kept_error) : Json(nullptr);
  json["clips"] = Json::array();
  for (const CalibrationScore& score : report.scores) {
    json["clips"].push_back({{"clip", score.clip},
                             {"mode", score.mode},
                             {"held_out", score.held_out},
                             {"ssim",
                              {{"calibrated", score.calibrated},
                               {"default", score.defaults},
                               {"paper", score.paper}}}});
  }
  json["fitted"] = Json::array();
  for (const CalibratedParameter& parameter : result.parameters) {
    json["fitted"].push_back(ToJson(parameter));
  }
  json["errors_at_gate_width"] = std::stod(fmt::format("{}", result.covariance_width));
  json["correlations"] = Json::array();
  const std::size_t size = result.parameters.size();
  for (std::size_t i = 0; i < size && !result.correlations.empty(); ++i) {
    const auto row = result.correlations.begin() + static_cast<std::ptrdiff_t>(i * size);
    json["correlations"].push_back(
        std::vector<double>(row, row + static_cast<std::ptrdiff_t>(size)));
  }
  json["starts"] = Json::array();
  for (const CalibrationStart& start : result.starts) {
    json["starts"].push_back(
        {{"name", start.name},
         {"from", ToJson(start.from)},
         {"to", ToJson(start.to)},
         {"complete", start.complete},
         {"optimum", start.optimum < 0 || !start.complete ? Json(nullptr) : Json(start.optimum)}});
  }
  json["optima"] = Json::array();
  for (const Candidate& optimum : result.optima) json["optima"].push_back(ToJson(optimum));
  return json;
}

std::string ToText(const CalibrationReport& report) {
  const CalibrationResult& result = report.result;
  std::string text = ToText(ParameterTable(result)) + "\n";
  if (!result.correlations.empty() && result.parameters.size() > 1) {
    text += ToText(CorrelationTable(result)) + "\n";
  }
  text += ToText(LossTable(report)) + "\n" + ToText(StartTable(result)) + OtherOptima(result);
  for (const std::string& sentence : Sentences(report)) text += sentence + "\n";
  return text;
}

}  // namespace warplut
