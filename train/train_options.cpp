#include "train/train_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "luts/certificate.h"
#include "runtime/parameters.h"

namespace warplut {
namespace {

constexpr int kFewestCrops = 16;

bool Refuse(std::string* why, std::string sentence) {
  if (why != nullptr) *why = std::move(sentence);
  return false;
}

// The decimal number that a float's shortest text stands for, so that a record shows 0.7.
double Decimal(float value) { return std::stod(fmt::format("{}", value)); }

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
  if (iterations == 0) {
    resolved.iterations =
        optimizer == Optimizer::kAdam ? kDefaultAdamIterations : kDefaultLbfgsIterations;
  }
  if (gain_bound == 0) resolved.gain_bound = DefaultGainBound(longest);
  const bool sr = objective == TrainObjective::kSr;
  resolved.pan_share = pan_share.value_or(sr ? kSrPanShare : 0.0);
  if (sr) {
    resolved.aliasing = aliasing.value_or(kSrAliasing);
    resolved.blend_a = blend_a.value_or(Decimal(Parameters().blend_a));
    resolved.blend_b = blend_b.value_or(Decimal(Parameters().blend_b));
  }
  if (crops == 0) resolved.crops = std::max(kFewestCrops, kDefaultCropWarps / longest);
  return resolved;
}

std::string TrainOptions::Json() const {
  nlohmann::ordered_json json = {{"scale", scale},
                                 {"horizons", horizons},
                                 {"optimizer", Name(optimizer)},
                                 {"seed", seed},
                                 {"stages", stages},
                                 {"iterations", iterations},
                                 {"gain_bound", gain_bound},
                                 {"pan_share", *pan_share},
                                 {"crops", crops},
                                 {"max_seconds", max_seconds}};
  if (objective == TrainObjective::kSr) {
    json["objective"] = Name(objective);
    json["blend_a"] = *blend_a;
    json["blend_b"] = *blend_b;
    json["aliasing"] = *aliasing;
  }
  return json.dump();
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
