// The stability certificate: how often one may warp with a table before an image can blow up.
// docs/CERTIFICATE.md derives it.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "luts/certificate/gain.h"
#include "luts/fit/fit.h"
#include "luts/quantize/lookup_error.h"

namespace warplut {

// The growth of a frequency's amplitude that still counts as bounded.
inline constexpr double kSafeGrowth = 2;

// Gains of at most 1 + kUnitGainTolerance count as 1: they never reach kSafeGrowth in half a
// million warps.
inline constexpr double kUnitGainTolerance = 1e-6;

// The default share of the current frame in the accumulation loop.
inline constexpr double kDefaultBlend = 0.1;

// Of the loop x <- (1 - blend) W x + blend u, with W a warp of this gain.
struct Loop {
  double gain = 0;                         // of one warp, without the blend
  std::optional<std::int64_t> safe_warps;  // SafeWarps(gain)
  double closed_loop_gain = 0;             // (1 - blend) * gain; the loop is stable below 1
  double smallest_blend = 0;               // blends above it make the closed-loop gain less than 1
};

struct Stability {
  double blend = kDefaultBlend;
  GainMap gains;
  Loop any;   // for any sequence of offsets: the worst node
  Loop half;  // for warps by (1/2, 1/2) alone
};

struct Certificate {
  Stability stability;
  std::vector<LookupError> lookup_errors;
};

// The largest N with gain^N <= kSafeGrowth; none if the gain is at most 1 + kUnitGainTolerance.
// gain >= 0.
std::optional<std::int64_t> SafeWarps(double gain);

// Of a checked table, as stored; blend in [0, 1] (not checked).
Stability CertifyStability(const TableView& table, double blend = kDefaultBlend);

// CertifyStability of the fit's table in `format`, and the lookup errors of all formats. An Error
// if the fit cannot be quantised.
Certificate Certify(const Fit& fit, TableFormat format, double blend = kDefaultBlend);

// For files: real numbers are rounded to 6 decimals, so that rounding in the last bit of a double
// leaves no trace.
nlohmann::ordered_json ToJson(const Certificate& certificate);

}  // namespace warplut
