// The options of a training.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "luts/fit/fit.h"

namespace warplut {

// The loss: that of repeated warps alone (warp_objective.h), or of warps in the accumulation loop
// of super resolution (sr_objective.h).
enum class TrainObjective : std::uint8_t { kWarp, kSr };

constexpr const char* Name(TrainObjective objective) {
  return objective == TrainObjective::kWarp ? "warp" : "sr";
}

enum class Optimizer : std::uint8_t { kLbfgs, kAdam };

constexpr const char* Name(Optimizer optimizer) {
  return optimizer == Optimizer::kLbfgs ? "lbfgs" : "adam";
}

// The prefilter that is trained with the weights.
//   kNone    none: a table that weighs samples
//   kSpline  that of the cubic spline with the least objective; the weights alone are trained
//   kIir     recursive, trained
//   kFir     of fir_taps taps, trained
enum class TrainPrefilter : std::uint8_t { kNone, kSpline, kIir, kFir };

// The longest half-pixel protocol is up to twice as long, and a fit must be able to record it.
inline constexpr int kMaxHorizon = kMaxRecordedWarps / 2;
inline constexpr int kDefaultStages = 3;
// Per stage. The start with a prefilter or more than 16 taps is near the end, and a warp costs
// more.
inline constexpr int kDefaultLbfgsIterations = 20;
inline constexpr int kDefaultPlainLbfgsIterations = 40;  // 16 taps without prefilter
inline constexpr int kDefaultWideLbfgsIterations = 24;   // 24 and 36 taps
inline constexpr int kDefaultAdamIterations = 100;

// The share of pans in objective `warp`, and there of 16 taps without prefilter.
inline constexpr double kPanShare = 1.0 / 3;
inline constexpr double kPlainPanShare = 0.08;
// The share with 24 and 36 taps: a larger one gains at pans and loses at random offsets.
inline constexpr double kWidePanShare = 0.12;

// The share of pans in objective `sr`.
inline constexpr double kSrPanShare = 0.3;

// The aliasing of samples in objective `sr`, in output pixels (docs/NOTES.md).
inline constexpr double kSrAliasing = 1.5;

// The work of one evaluation: crops times the longest horizon. More crops generalise better and
// take longer.
inline constexpr int kDefaultCropWarps = 12 * 64;
inline constexpr int kDefaultPlainCropWarps = 32 * 64;  // 16 taps without prefilter
inline constexpr int kDefaultWideCropWarps = 18 * 64;   // 24 and 36 taps

inline constexpr int kFewestCrops = 12;

struct TrainOptions {
  TrainObjective objective = TrainObjective::kWarp;
  double scale = 2;           // output / render, [1, 4]
  std::vector<int> horizons;  // even, ascending, at most kMaxHorizon; empty: DefaultHorizons(scale)
  // a and b of objective `sr`, in the ranges of runtime/parameters.h; empty: the defaults there.
  // Not for objective `warp`.
  std::optional<double> blend_a, blend_b;
  // Aliasing of samples in objective `sr`, in [0, 4]; empty: kSrAliasing. Not for objective `warp`.
  std::optional<double> aliasing;
  Footprint footprint = Footprint::k16;  // others without a prefilter
  TrainPrefilter prefilter = TrainPrefilter::kIir;
  int fir_taps = 0;  // of kFir: odd, 3 to 15; otherwise 0
  Optimizer optimizer = Optimizer::kLbfgs;
  std::uint64_t seed = 1;
  int threads = 0;         // 0: all
  double max_seconds = 0;  // 0: no limit; one that cuts makes the result depend on the machine
  int stages = kDefaultStages;
  int iterations = 0;     // per stage; 0: the optimizer's default
  double gain_bound = 0;  // largest |H| of any node and frequency; 0: DefaultGainBound
  // Share of pans in the objective, [0, 1): a larger one keeps pans from drifting. Empty:
  // kPanShare, without prefilter kPlainPanShare, with objective `sr` kSrPanShare.
  std::optional<double> pan_share;
  int crops = 0;  // 0: by the work above, at least kFewestCrops
  // Empty: none. Written after each stage and every few seconds inside it; removed at the end,
  // unless max_seconds cut.
  std::filesystem::path checkpoint;
  bool resume = false;  // from `checkpoint`

  bool IsValid(std::string* why) const;

  // The same with every 0 and empty list replaced by the default that it stands for.
  TrainOptions Resolved() const;

  // All options that decide the result, as a JSON object on one line. The options are resolved.
  std::string Json() const;
};

// "none", "spline", "iir" or "fir:N" of the options, and back: returns false and leaves them alone
// if `text` is none of these. N is checked by TrainOptions::IsValid.
std::string PrefilterName(const TrainOptions& options);
bool SetPrefilter(const std::string& text, TrainOptions* options);

// The reach of kFir's taps; 0 for the others.
constexpr int FirReach(const TrainOptions& options) { return options.fir_taps / 2; }

// Numbers of warps to train for at factor `scale`. With the jitter cycle of P = 8 scale^2 frames
// (the rule of FSR 2) they are about 3/16 P, 3/8 P, 3/4 P and 2 P, even; 6, 12, 24 and 64 at factor
// 2.
std::vector<int> DefaultHorizons(double scale);

// The gain whose power at the longest horizon is kSafeGrowth (luts/certificate/certificate.h), less
// kGrowthReserve of its logarithm for the excess of the penalty and of quantisation.
double DefaultGainBound(int longest_horizon);

inline constexpr double kGrowthReserve = 0.1;

}  // namespace warplut
