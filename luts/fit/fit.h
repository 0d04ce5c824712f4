// A fit: the result of a training and its provenance. The seam between train/ and the bakers,
// stored as JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "luts/fit/mlp.h"
#include "luts/prefilter.h"

namespace warplut {

// One image that was trained on. `sha1` is of the file's bytes.
struct FitData {
  std::string name;  // relative to the folder or sequence given, never an absolute path
  std::string sha1;
  int width = 0;
  int height = 0;

  // Whether a fit can record it; if not, *why says what is wrong with which field.
  bool IsValid(std::string* why) const;
};

// A point of the loss over time.
struct FitLoss {
  double seconds = 0;
  std::int64_t evaluations = 0;  // of the objective
  double loss = 0;               // training objective
  double validation = 0;         // the same objective on crops that are not trained on
};

// A validation score: mean SSIM after `warps` warps.
struct FitScore {
  std::string filter;  // "lut", "keys", "catmull-rom", "spline", "spline-1/84", "kaiser6-4.5"
  int warps = 0;
  std::string offsets;  // "half", "random" or "pan"
  double ssim = 0;
};

// Whether `text` can name a fit, and what is generated from it: ASCII letters, digits and _, the
// first not a digit.
bool IsIdentifier(std::string_view text);

// The most warps that a fit records, of a horizon or a score.
inline constexpr int kMaxRecordedWarps = 1024;

struct Fit {
  // A fit of 16 taps without prefilter is written as version 1, the others as version 2.
  static constexpr int kVersion = 2;

  std::string name;                // IsIdentifier
  double scale = 2;                // output / render, >= 1
  std::string objective = "warp";  // or "sr"
  std::string optimizer;           // "lbfgs", "adam", "lm"
  std::vector<int> horizons;       // numbers of warps, ascending, each in [1, kMaxRecordedWarps]
  double gain_bound = 0;           // largest |H| asked for, of any node and frequency
  double keys_a = 0;               // the best Keys kernel on the same data and loss
  double spline_k = 0;             // with a prefilter: the best spline within the bound, likewise
  std::uint64_t seed = 0;
  std::string options;  // the training's options: a JSON object on one line
  bool cut = false;     // a time limit ended the training before its work was done
  Footprint footprint = Footprint::k16;
  double kaiser_b = 0;             // of 24 and 36 taps: of the base (luts/wide_kernel.h)
  std::vector<double> parameters;  // MlpParameters(footprint) finite values
  Prefilter prefilter = {};        // none but with 16 taps
  std::vector<FitData> data;
  std::vector<FitLoss> loss;
  std::vector<FitScore> validation;

  bool IsValid(std::string* why) const;
};

// Reads and checks a fit. An Error names the file, the field, what was found and what was expected;
// a fit of a later version is refused.
Fit ReadFit(const std::filesystem::path& path);

// Writes atomically; the same fit gives the same bytes. An Error if it is not valid.
void WriteFit(const std::filesystem::path& path, const Fit& fit);

}  // namespace warplut
