#include "luts/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/json_fields.h"
#include "luts/fit/fit_records.h"
#include "luts/fit/json_header.h"
#include "luts/fit/prefilter_json.h"
#include "luts/footprint_names.h"
#include "luts/wide_kernel.h"

namespace warplut {
namespace {

constexpr std::size_t kSha1Digits = 40;

bool OneOf(const std::string& text, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* item) { return text == item; });
}

// One line: no control characters.
bool IsLine(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127; });
}

bool IsJsonObjectLine(const std::string& text) {
  if (!IsLine(text)) return false;
  try {
    return ParseJson(text, "options").is_object();
  } catch (const Error&) {
    return false;
  }
}

bool IsSha1(const std::string& text) {
  return text.size() == kSha1Digits && std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return std::isdigit(c) || (c >= 'a' && c <= 'f');
         });
}

// The sentence about the first field that is wrong, or "".
std::string HeadFault(const Fit& fit) {
  if (!IsIdentifier(fit.name)) {
    return fmt::format(
        "name is \"{}\", expected letters, digits and _, of which the first is no digit", fit.name);
  }
  if (!std::isfinite(fit.scale) || fit.scale < 1) {
    return fmt::format("scale is {}, expected a finite number of at least 1", fit.scale);
  }
  if (!OneOf(fit.objective, {"warp", "sr"})) {
    return fmt::format("objective is \"{}\", expected warp or sr", fit.objective);
  }
  if (!OneOf(fit.optimizer, {"lbfgs", "adam", "lm"})) {
    return fmt::format("optimizer is \"{}\", expected lbfgs, adam or lm", fit.optimizer);
  }
  if (fit.horizons.empty()) return "horizons is empty, expected at least one number of warps";
  for (std::size_t i = 0; i < fit.horizons.size(); ++i) {
    const int horizon = fit.horizons[i];
    const int least = i == 0 ? 1 : fit.horizons[i - 1] + 1;
    if (horizon < least || horizon > kMaxRecordedWarps) {
      return fmt::format("horizons[{}] is {}, expected ascending numbers, here one in [{}, {}]", i,
                         horizon, least, kMaxRecordedWarps);
    }
  }
  if (!std::isfinite(fit.gain_bound) || fit.gain_bound < 0) {
    return fmt::format("gain_bound is {}, expected a finite number of at least 0", fit.gain_bound);
  }
  if (!std::isfinite(fit.keys_a)) {
    return fmt::format("keys_a is {}, expected a finite number", fit.keys_a);
  }
  if (!std::isfinite(fit.spline_k)) {
    return fmt::format("spline_k is {}, expected a finite number", fit.spline_k);
  }
  if (!IsJsonObjectLine(fit.options)) {
    return fmt::format("options is '{}', expected one line with a JSON object", fit.options);
  }
  if (!(fit.kaiser_b >= 0 && fit.kaiser_b <= kLargestKaiser)) {
    return fmt::format("kaiser_b is {}, expected a number in [0, {}]", fit.kaiser_b,
                       kLargestKaiser);
  }
  if (fit.footprint == Footprint::k16 && fit.kaiser_b != 0) {
    return fmt::format("kaiser_b is {}, expected 0 of {} taps", fit.kaiser_b,
                       TapCount(fit.footprint));
  }
  const auto expected = static_cast<std::size_t>(MlpParameters(fit.footprint));
  if (fit.parameters.size() != expected) {
    return fmt::format("parameters has {} values, expected {}", fit.parameters.size(), expected);
  }
  const char* why = nullptr;
  if (!IsValid(fit.prefilter, &why)) return fmt::format("prefilter {}", why);
  if (const std::string fault = FootprintFault(fit.footprint, fit.prefilter); !fault.empty()) {
    return "prefilter is of a fit that " + fault;
  }
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    if (!std::isfinite(fit.parameters[i])) {
      return fmt::format("parameters[{}] is {}, expected a finite number", i, fit.parameters[i]);
    }
  }
  return "";
}

std::string RecordFault(const Fit& fit) {
  for (std::size_t i = 0; i < fit.data.size(); ++i) {
    std::string why;
    if (!fit.data[i].IsValid(&why)) return fmt::format("data[{}]{}", i, why);
  }
  for (std::size_t i = 0; i < fit.loss.size(); ++i) {
    const FitLoss& loss = fit.loss[i];
    if (!std::isfinite(loss.seconds) || !std::isfinite(loss.loss) ||
        !std::isfinite(loss.validation)) {
      return fmt::format("loss[{}] has a value that is not finite", i);
    }
    if (loss.seconds < 0 || loss.evaluations < 0) {
      return fmt::format("loss[{}] has negative seconds or evaluations", i);
    }
  }
  for (std::size_t i = 0; i < fit.validation.size(); ++i) {
    const FitScore& score = fit.validation[i];
    if (!OneOf(score.filter,
               {"lut", "keys", "catmull-rom", "spline", "spline-1/84", "kaiser6-4.5"})) {
      return fmt::format(
          "validation[{}].filter is \"{}\", expected lut, keys, catmull-rom, spline, spline-1/84 "
          "or "
          "kaiser6-4.5",
          i, score.filter);
    }
    if (!OneOf(score.offsets, {"half", "random", "pan"})) {
      return fmt::format("validation[{}].offsets is \"{}\", expected half, random or pan", i,
                         score.offsets);
    }
    if (score.warps < 1 || score.warps > kMaxRecordedWarps) {
      return fmt::format("validation[{}].warps is {}, expected a number in [1, {}]", i, score.warps,
                         kMaxRecordedWarps);
    }
    if (!(score.ssim >= -1 && score.ssim <= 1)) {
      return fmt::format("validation[{}].ssim is {}, expected a number in [-1, 1]", i, score.ssim);
    }
  }
  return "";
}

nlohmann::ordered_json ToJson(const Fit& fit) {
  nlohmann::ordered_json json;
  json["format"] = kFitFormat;
  const bool wide = fit.footprint != Footprint::k16;
  json["version"] = wide || HasPrefilter(fit.prefilter) ? Fit::kVersion : 1;
  json["name"] = fit.name;
  json["scale"] = fit.scale;
  json["objective"] = fit.objective;
  json["optimizer"] = fit.optimizer;
  json["horizons"] = fit.horizons;
  json["gain_bound"] = fit.gain_bound;
  json["keys_a"] = fit.keys_a;
  if (HasPrefilter(fit.prefilter)) json["spline_k"] = fit.spline_k;
  json["seed"] = fit.seed;
  json["options"] = fit.options;
  if (fit.cut) json["ended"] = kCutFit;
  json["data"] = fit.data;
  nlohmann::ordered_json& loss = json["loss"] = nlohmann::ordered_json::array();
  for (const FitLoss& l : fit.loss) {
    loss.push_back({{"seconds", l.seconds},
                    {"evaluations", l.evaluations},
                    {"loss", l.loss},
                    {"validation", l.validation}});
  }
  json["validation"] = fit.validation;
  if (HasPrefilter(fit.prefilter)) json["prefilter"] = ToJson(fit.prefilter);
  WriteFootprint(fit.footprint, json);
  if (wide) json["kaiser_b"] = fit.kaiser_b;
  json["parameters"] = fit.parameters;
  return json;
}

// A whole number of 0 or above, of 64 bits.
template <class T>
T Whole(JsonFields& fields, const char* name) {
  const nlohmann::json& value = fields.Take(name);
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<T>::max())) {
    fields.At(name).Refuse(value, "a whole number of at least 0");
  }
  return value.get<T>();
}

// The objects of an array, each read by `read`.
template <class T, class Read>
std::vector<T> Objects(JsonFields& fields, const char* name, const Read& read) {
  std::vector<T> items;
  const JsonPlace place = fields.At(name);
  for (const nlohmann::json& value : place.Array(fields.Take(name))) {
    JsonFields item(value, place.Element(items.size()));
    items.push_back(read(item));
    item.Finish();
  }
  return items;
}

FitData ReadData(JsonFields& item) {
  return {item.Text("name"), item.Text("sha1"), item.Integer("width"), item.Integer("height")};
}

FitLoss ReadLoss(JsonFields& item) {
  return {item.Number("seconds"), Whole<std::int64_t>(item, "evaluations"), item.Number("loss"),
          item.Number("validation")};
}

FitScore ReadScore(JsonFields& item) {
  return {item.Text("filter"), item.Integer("warps"), item.Text("offsets"), item.Number("ssim")};
}

Fit FromJson(JsonFields fields) {
  const int version = CheckHeader(fields, kFitFormat, 1, Fit::kVersion);
  Fit fit;
  if (version > 1) fit.footprint = ReadFootprint(fields);
  if (fit.footprint != Footprint::k16) fit.kaiser_b = fields.Number("kaiser_b");
  // Both taps and a prefilter is one too many, which IsValid says.
  if (version > 1 && (fit.footprint == Footprint::k16 || fields.Has("prefilter"))) {
    fit.prefilter = ReadPrefilter(fields.Object("prefilter"));
    fit.spline_k = fields.Number("spline_k");
  }
  fit.name = fields.Text("name");
  fit.scale = fields.Number("scale");
  fit.objective = fields.Text("objective");
  fit.optimizer = fields.Text("optimizer");
  const JsonPlace horizons = fields.At("horizons");
  for (const nlohmann::json& value : horizons.Array(fields.Take("horizons"))) {
    fit.horizons.push_back(horizons.Element(fit.horizons.size()).Integer(value));
  }
  fit.gain_bound = fields.Number("gain_bound");
  fit.keys_a = fields.Number("keys_a");
  fit.seed = Whole<std::uint64_t>(fields, "seed");
  fit.options = fields.Text("options");
  if (fields.Has("ended")) {
    const std::string ended = fields.Text("ended");
    if (ended != kCutFit) fields.At("ended").Refuse(ended, "\"time limit\", or no such field");
    fit.cut = true;
  }
  fit.data = Objects<FitData>(fields, "data", ReadData);
  fit.loss = Objects<FitLoss>(fields, "loss", ReadLoss);
  fit.validation = Objects<FitScore>(fields, "validation", ReadScore);
  const JsonPlace parameters = fields.At("parameters");
  for (const nlohmann::json& value : parameters.Array(fields.Take("parameters"))) {
    fit.parameters.push_back(parameters.Element(fit.parameters.size()).Number(value));
  }
  fields.Finish();
  return fit;
}

}  // namespace

bool IsIdentifier(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !text.empty() && !is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

bool FitData::IsValid(std::string* why) const {
  if (name.empty() || name[0] == '/' || !IsLine(name)) {
    *why = fmt::format(".name is \"{}\", expected a relative path of one line", name);
  } else if (!IsSha1(sha1)) {
    *why = fmt::format(".sha1 is \"{}\", expected {} hexadecimal digits in lower case", sha1,
                       kSha1Digits);
  } else if (width < 1 || height < 1) {
    *why = fmt::format(" is {} x {}, expected at least 1 x 1", width, height);
  } else {
    return true;
  }
  return false;
}

bool Fit::IsValid(std::string* why) const {
  std::string fault = HeadFault(*this);
  if (fault.empty()) fault = RecordFault(*this);
  if (why != nullptr) *why = fault;
  return fault.empty();
}

Fit ReadFit(const std::filesystem::path& path) {
  const nlohmann::json json = ReadJson(path);
  Fit fit = FromJson(JsonFields(json, JsonPlace(path.string(), "")));
  std::string why;
  if (!fit.IsValid(&why)) throw Error(fmt::format("'{}': field {}", path.string(), why));
  return fit;
}

void WriteFit(const std::filesystem::path& path, const Fit& fit) {
  std::string why;
  if (!fit.IsValid(&why))
    throw Error(fmt::format("cannot write '{}': field {}", path.string(), why));
  WriteFile(path, JsonText(ToJson(fit), 1) + "\n");
}

}  // namespace warplut
