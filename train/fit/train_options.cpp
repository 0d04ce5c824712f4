#include "train/fit/train_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "datasets/json_fields.h"
#include "luts/certificate/certificate.h"
#include "runtime/parameters.h"

namespace warplut {
namespace {

constexpr std::array<std::pair<const char*, TrainPrefilter>, 3> kPrefilterNames = {
    {{"none", TrainPrefilter::kNone},
     {"spline", TrainPrefilter::kSpline},
     {"iir", TrainPrefilter::kIir}}};
constexpr const char* kFirName = "fir:";

bool Refuse(std::string* why, std::string sentence) {
  if (why != nullptr) *why = std::move(sentence);
  return false;
}

int Even(double warps) { return std::max(2, 2 * static_cast<int>(std::lround(warps / 2))); }

}  // namespace

bool TrainOptions::IsValid(std::string* why) const {
  if (!(scale >= 1 && scale <= 4)) {
    return Refuse(why, fmt::format("scale is {}; expected a number in [1, 4].", scale));
  }
  int last = 0;
  for (const int horizon : horizons) {
    if (horizon <= last || horizon % 2 != 0 || horizon > kMaxHorizon) {
      return Refuse(why, fmt::format("horizon {} follows {}; expected even numbers of warps, "
                                     "ascending, at most {}.",
                                     horizon, last, kMaxHorizon));
    }
    last = horizon;
  }
  if (footprint != Footprint::k16 && prefilter != TrainPrefilter::kNone) {
    return Refuse(why,
                  fmt::format("taps is {} with prefilter {}; expected prefilter none with more "
                              "than {} taps.",
                              TapCount(footprint), PrefilterName(*this), TapCount(Footprint::k16)));
  }
  const bool is_fir = prefilter == TrainPrefilter::kFir;
  if (is_fir && !(fir_taps % 2 == 1 && fir_taps >= 3 && FirReach(*this) <= kLargestFirReach)) {
    return Refuse(why, fmt::format("fir_taps is {}; expected an odd number of 3 to {} taps.",
                                   fir_taps, 2 * kLargestFirReach + 1));
  }
  if (!is_fir && fir_taps != 0) {
    return Refuse(why,
                  fmt::format("fir_taps is {}; expected it with prefilter fir alone.", fir_taps));
  }
  if (objective != TrainObjective::kSr && (blend_a || blend_b)) {
    return Refuse(why, "blend_a or blend_b is set; expected them with objective sr alone.");
  }
  if (aliasing && objective != TrainObjective::kSr) {
    return Refuse(why, "aliasing is set; expected it with objective sr alone.");
  }
  if (aliasing && !(*aliasing >= 0 && *aliasing <= 4)) {
    return Refuse(why, fmt::format("aliasing is {}; expected a number in [0, 4].", *aliasing));
  }
  Parameters blend;
  if (blend_a) blend.blend_a = static_cast<float>(*blend_a);
  if (blend_b) blend.blend_b = static_cast<float>(*blend_b);
  if (!blend.IsValid(why)) return false;
  if (threads < 0) return Refuse(why, fmt::format("threads is {}; expected 0 or more.", threads));
  if (!(max_seconds >= 0)) {
    return Refuse(why, fmt::format("max_seconds is {}; expected 0 or more.", max_seconds));
  }
  if (stages < 1) return Refuse(why, fmt::format("stages is {}; expected 1 or more.", stages));
  if (iterations < 0) {
    return Refuse(why, fmt::format("iterations is {}; expected 0 or more.", iterations));
  }
  if (gain_bound != 0 && !(gain_bound >= 1 && gain_bound <= 2)) {
    return Refuse(why, fmt::format("gain_bound is {}; expected a number in [1, 2].", gain_bound));
  }
  if (pan_share && !(*pan_share >= 0 && *pan_share < 1)) {
    return Refuse(why, fmt::format("pan_share is {}; expected a number in [0, 1).", *pan_share));
  }
  if (crops < 0) return Refuse(why, fmt::format("crops is {}; expected 0 or more.", crops));
  if (resume && checkpoint.empty()) {
    return Refuse(why, "resume is set without a checkpoint; expected the path of one.");
  }
  return true;
}

TrainOptions TrainOptions::Resolved() const {
  TrainOptions resolved = *this;
  if (horizons.empty()) resolved.horizons = DefaultHorizons(scale);
  const int longest = resolved.horizons.back();
  const bool wide = footprint != Footprint::k16;
  const bool plain = prefilter == TrainPrefilter::kNone && !wide;
  if (iterations == 0) {
    resolved.iterations = optimizer == Optimizer::kAdam ? kDefaultAdamIterations
                          : plain                       ? kDefaultPlainLbfgsIterations
                          : wide                        ? kDefaultWideLbfgsIterations
                                                        : kDefaultLbfgsIterations;
  }
  if (gain_bound == 0) resolved.gain_bound = DefaultGainBound(longest);
  const bool sr = objective == TrainObjective::kSr;
  const double warp_share = wide ? kWidePanShare : plain ? kPlainPanShare : kPanShare;
  resolved.pan_share = pan_share.value_or(sr ? kSrPanShare : warp_share);
  if (sr) {
    resolved.aliasing = aliasing.value_or(kSrAliasing);
    resolved.blend_a = blend_a.value_or(Decimal(Parameters().blend_a));
    resolved.blend_b = blend_b.value_or(Decimal(Parameters().blend_b));
  }
  if (crops == 0) {
    const int work = wide    ? kDefaultWideCropWarps
                     : plain ? kDefaultPlainCropWarps
                             : kDefaultCropWarps;
    resolved.crops = std::max(kFewestCrops, work / longest);
  }
  return resolved;
}

std::string TrainOptions::Json() const {
  nlohmann::ordered_json json = {{"scale", scale},
                                 {"horizons", horizons},
                                 {"prefilter", PrefilterName(*this)},
                                 {"optimizer", Name(optimizer)},
                                 {"seed", seed},
                                 {"stages", stages},
                                 {"iterations", iterations},
                                 {"gain_bound", gain_bound},
                                 {"pan_share", *pan_share},
                                 {"crops", crops},
                                 {"max_seconds", max_seconds}};
  if (footprint != Footprint::k16) json["taps"] = TapCount(footprint);
  if (objective == TrainObjective::kSr) {
    json["objective"] = Name(objective);
    json["blend_a"] = *blend_a;
    json["blend_b"] = *blend_b;
    json["aliasing"] = *aliasing;
  }
  return JsonText(json);
}

std::string PrefilterName(const TrainOptions& options) {
  for (const auto& [name, kind] : kPrefilterNames) {
    if (kind == options.prefilter) return name;
  }
  return fmt::format("{}{}", kFirName, options.fir_taps);
}

bool SetPrefilter(const std::string& text, TrainOptions* options) {
  for (const auto& [name, kind] : kPrefilterNames) {
    if (text != name) continue;
    options->prefilter = kind;
    options->fir_taps = 0;
    return true;
  }
  const std::string_view fir = kFirName;
  int taps = 0;
  const char* end = text.data() + text.size();
  if (!text.starts_with(fir)) return false;
  const auto [parsed, error] = std::from_chars(text.data() + fir.size(), end, taps);
  if (error != std::errc() || parsed != end) return false;
  options->prefilter = TrainPrefilter::kFir;
  options->fir_taps = taps;
  return true;
}

std::vector<int> DefaultHorizons(double scale) {
  const double cycle = 8 * scale * scale;
  std::vector<int> horizons;
  for (const double share : {3.0 / 16, 3.0 / 8, 3.0 / 4, 2.0}) {
    const int previous = horizons.empty() ? 0 : horizons.back();
    horizons.push_back(std::max(previous + 2, Even(share * cycle)));
  }
  return horizons;
}

double DefaultGainBound(int longest_horizon) {
  return std::pow(kSafeGrowth, (1 - kGrowthReserve) / longest_horizon);
}

}  // namespace warplut
