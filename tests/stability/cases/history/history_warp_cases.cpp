#include "tests/stability/cases/history/history_warp_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "luts/certificate/certificate.h"
#include "runtime/core/pixel.h"
#include "runtime/image_buffer.h"
#include "tests/stability/cases/history/history_loop.h"
#include "tests/stability/cases/stability_clip.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr Lookup kLookups[] = {Lookup::kNearest, Lookup::kBilinear};

// Speeds of a pan, pixels per frame: no whole number of frames brings the offset back.
constexpr float kWarpX = std::numbers::sqrt2_v<float>;
constexpr float kWarpY = -std::numbers::phi_v<float>;

constexpr double kConstant = 173.0 / 255;  // a code, for 8-bit histories

int Frames(StabilityEffort effort) { return effort == StabilityEffort::kFull ? 10000 : 1000; }

struct ShippedTable {
  const TableView& stored;
  const Table& table;
};

std::array<ShippedTable, 2> ShippedTables() {
  return {{{StoredHistoryTable(), HistoryTable()}, {StoredWarpTable(), WarpTable()}}};
}

WarpOptions Lut(const Table& table, Lookup lookup) {
  return {.filter = Filter::kLut, .table = &table, .lookup = lookup};
}

// A wave that fits the torus, near the one that the worst node of a table amplifies most.
struct Wave {
  double fx = 0, fy = 0;        // radians per pixel
  std::complex<double> factor;  // what one warp by the node does to it
  float motion_x = 0, motion_y = 0;
};

Wave WorstWave(const TableView& stored, const Table& table, int size) {
  const Stability stability = CertifyStability(stored);
  const Gain& worst = stability.gains.nodes[static_cast<std::size_t>(stability.gains.worst)];
  const double step = 2 * std::numbers::pi / size;
  Wave wave;
  wave.fx = std::round(worst.fx / step) * step;
  wave.fy = std::round(worst.fy / step) * step;
  const float dx = static_cast<float>(NodeOffset(stability.gains.worst % kNodes));
  const float dy = static_cast<float>(NodeOffset(stability.gains.worst / kNodes));
  wave.motion_x = -dx;
  wave.motion_y = -dy;
  const Weights<float> weights = table.At(dx, dy, Lookup::kNearest);
  for (int k = 0; k < kWeights; ++k) {
    wave.factor +=
        static_cast<double>(weights[k]) * std::polar(1.0, wave.fx * TapX(k) + wave.fy * TapY(k));
  }
  return wave;
}

void FillNoise(int frame, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 0.25 + 0.5 * static_cast<double>(Noise(static_cast<int>(i), 0, frame));
  }
}

void FillConstant(int, std::span<double> values) {
  std::fill(values.begin(), values.end(), kConstant);
}

// A wave on a torus. Advanced by its factor in every frame, as the loop advances what came before:
// in phase, the worst that can happen to the loop. `advance` false: it stays where it is.
LoopInput WaveInput(const Wave& wave, int size, double amplitude, bool advance) {
  return [=](int frame, std::span<double> values) {
    const double phase = advance ? frame * std::arg(wave.factor) : 0.0;
    std::complex<double> row = std::polar(amplitude, phase);
    const std::complex<double> right = std::polar(1.0, wave.fx), down = std::polar(1.0, wave.fy);
    for (int y = 0; y < size; ++y, row *= down) {
      std::complex<double> value = row;
      for (int x = 0; x < size; ++x, value *= right) {
        values[static_cast<std::size_t>(y * size + x)] = 0.5 + value.real();
      }
    }
  };
}

// The loop in every format of a history. `passed`: the prediction holds for every frame and the
// values stay finite.
struct FormatsResult {
  bool passed = true;
  std::string text;  // the worst ratio to the prediction, and the size after the last frame
  LoopResult runs[std::size(kColorFormats)];
};

FormatsResult RunFormats(LoopOptions options) {
  FormatsResult all;
  for (std::size_t i = 0; i < std::size(kColorFormats); ++i) {
    options.format = kColorFormats[i];
    const LoopResult& run = all.runs[i] = RunLoop(options);
    all.passed = all.passed && run.worst_ratio <= 1;
    all.text += fmt::format("{}{} {:.4f} of the bound, size {:.3g} to {:.3g}", i == 0 ? "" : "; ",
                            Name(options.format), run.worst_ratio, run.first, run.last);
    if (run.judged < options.frames) {
      all.text += fmt::format(", above 4 after {} frames", run.judged);
    }
    if (!run.finite) all.text += ", infinite in the end";
  }
  return all;
}

}  // namespace

StabilityResult WarpOfStaticImage(StabilityEffort effort) {
  constexpr int kWidth = 19, kHeight = 7;
  const MotionBuffer still(kWidth, kHeight);
  int changed = 0, runs = 0;
  for (const ShippedTable& shipped : ShippedTables()) {
    for (const Lookup lookup : kLookups) {
      for (const PixelFormat format : kColorFormats) {
        WarpOptions options = Lut(shipped.table, lookup);
        options.general_only = true;
        ImageBuffer image(kWidth, kHeight, format), next(kWidth, kHeight, format);
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < 4 * kWidth; ++x) {
            const float value = Noise(x, y, 0);
            StoreChannel(format, format == PixelFormat::kRgba8 ? 255 * value : value,
                         image.view().At(0, y), x);
          }
        }
        ImageBuffer first(kWidth, kHeight, format);
        CopyPixels(image.view(), first.view());
        for (int warp = 0; warp < Frames(effort); ++warp) {
          Warp(image.view(), still.view(), options, next.view());
          std::swap(image, next);
        }
        ++runs;
        changed += SameBits(image.view(), first.view()) ? 0 : 1;
      }
    }
  }
  return {changed == 0,
          fmt::format("{} of {} runs of {} warps changed a bit", changed, runs, Frames(effort))};
}

StabilityResult WarpOfConstantImage(StabilityEffort effort) {
  double worst = 0;
  for (const ShippedTable& shipped : ShippedTables()) {
    for (const Lookup lookup : kLookups) {
      LoopOptions options{.warp = Lut(shipped.table, lookup),
                          .motion_x = kWarpX,
                          .motion_y = kWarpY,
                          .size = 8,
                          .frames = Frames(effort),
                          .center = kConstant,
                          .first = FillConstant,
                          .input = {}};
      for (const PixelFormat format : kColorFormats) {
        options.format = format;
        worst = std::max(worst, RunLoop(options).last);
      }
    }
  }
  return {worst <= kHalfCode, fmt::format("off by at most {:.2g} of a code value after {} warps",
                                          worst * 255, Frames(effort))};
}

StabilityResult WarpOfWorstWave(StabilityEffort) {
  constexpr int kSize = 64;
  constexpr double kAmplitude = 0.15;
  StabilityResult result{.passed = true, .observed = {}};
  for (const ShippedTable& shipped : ShippedTables()) {
    const Stability certificate = CertifyStability(shipped.stored);
    const Wave wave = WorstWave(shipped.stored, shipped.table, kSize);
    const int safe = static_cast<int>(certificate.any.safe_warps.value_or(10000));
    const FormatsResult formats = RunFormats({.warp = Lut(shipped.table, Lookup::kBilinear),
                                              .motion_x = wave.motion_x,
                                              .motion_y = wave.motion_y,
                                              .gain = certificate.any.gain,
                                              .size = kSize,
                                              .frames = safe,
                                              .first = WaveInput(wave, kSize, kAmplitude, false),
                                              .input = {}});
    const LoopResult& exact = formats.runs[std::size(kColorFormats) - 1];
    const double growth = exact.last / exact.first;
    const double predicted = std::pow(std::abs(wave.factor), safe);
    result.passed = result.passed && formats.passed && growth <= kSafeGrowth &&
                    std::abs(growth / predicted - 1) <= 1e-3;
    result.observed += fmt::format("{}{} warps: grown {:.4f}-fold, predicted {:.4f}",
                                   result.observed.empty() ? "" : "; ", safe, growth, predicted);
  }
  return result;
}

StabilityResult WarpPan(StabilityEffort effort) {
  const WarpOptions warp = HistoryWarp();
  const FormatsResult formats = RunFormats({.warp = warp,
                                            .motion_x = kWarpX,
                                            .motion_y = kWarpY,
                                            .gain = GainOfMotion(warp, kWarpX, kWarpY),
                                            .frames = Frames(effort),
                                            .first = FillNoise,
                                            .input = {}});
  return {formats.passed, formats.text};
}

StabilityResult LoopOfWorstWave(StabilityEffort effort) {
  constexpr int kSize = 32;
  constexpr double kAmplitude = 0.2;
  const Stability certificate = CertifyStability(StoredHistoryTable());
  const Wave wave = WorstWave(StoredHistoryTable(), HistoryTable(), kSize);
  StabilityResult result{.passed = true, .observed = {}};
  for (const double blend : {kDefaultBlend, 2 * certificate.any.smallest_blend}) {
    const LoopInput input = WaveInput(wave, kSize, kAmplitude, true);
    const FormatsResult formats = RunFormats({.warp = HistoryWarp(),
                                              .motion_x = wave.motion_x,
                                              .motion_y = wave.motion_y,
                                              .gain = certificate.any.gain,
                                              .blend = blend,
                                              .size = kSize,
                                              .frames = Frames(effort),
                                              .first = input,
                                              .input = input});
    const LoopResult& exact = formats.runs[std::size(kColorFormats) - 1];
    const double growth = exact.last / exact.first;
    const double predicted = blend / (1 - (1 - blend) * std::abs(wave.factor));
    result.passed = result.passed && formats.passed && std::abs(growth / predicted - 1) <= 1e-2;
    result.observed += fmt::format(
        "{}blend {:.3f}: {:.4f}-fold, predicted {:.4f}, {:.4f} of the bound",
        result.observed.empty() ? "" : "; ", blend, growth, predicted, formats.runs[0].worst_ratio);
  }
  return result;
}

StabilityResult LoopPan(StabilityEffort effort) {
  constexpr int kSize = 32;
  const WarpOptions warp = HistoryWarp();
  const auto input = [](int frame, std::span<double> values) {
    float color[3];
    for (int i = 0; i < kSize * kSize; ++i) {
      Texture(i % kSize - frame * static_cast<double>(kWarpX),
              i / kSize - frame * static_cast<double>(kWarpY), kSize, color);
      values[static_cast<std::size_t>(i)] = static_cast<double>(color[0]);
    }
  };
  const FormatsResult formats = RunFormats({.warp = warp,
                                            .motion_x = kWarpX,
                                            .motion_y = kWarpY,
                                            .gain = GainOfMotion(warp, kWarpX, kWarpY),
                                            .blend = kDefaultBlend,
                                            .size = kSize,
                                            .frames = Frames(effort),
                                            .first = input,
                                            .input = input});
  double drift = 0;
  for (const LoopResult& run : formats.runs) drift = std::max(drift, run.drift);
  return {formats.passed && drift <= kHalfCode,
          formats.text + fmt::format("; mean drifts by {:.2g} of a code value", drift * 255)};
}

StabilityResult LoopFlicker(StabilityEffort effort) {
  const WarpOptions warp = HistoryWarp();
  const FormatsResult formats =
      RunFormats({.warp = warp,
                  .motion_x = kWarpX,
                  .motion_y = kWarpY,
                  .gain = GainOfMotion(warp, kWarpX, kWarpY),
                  .blend = kDefaultBlend,
                  .frames = Frames(effort),
                  .first = FillNoise,
                  .input = [](int frame, auto values) { FillNoise(frame % 2, values); }});
  return {formats.passed, formats.text};
}

StabilityResult LoopConstant(StabilityEffort effort) {
  double worst = 0;
  for (const ShippedTable& shipped : ShippedTables()) {
    LoopOptions options{.warp = Lut(shipped.table, Lookup::kBilinear),
                        .motion_x = kWarpX,
                        .motion_y = kWarpY,
                        .blend = kDefaultBlend,
                        .size = 8,
                        .frames = Frames(effort),
                        .center = kConstant,
                        .first = FillConstant,
                        .input = FillConstant};
    for (const PixelFormat format : kColorFormats) {
      options.format = format;
      worst = std::max(worst, RunLoop(options).last);
    }
  }
  return {worst <= kHalfCode, fmt::format("off by at most {:.2g} of a code value after {} frames",
                                          worst * 255, Frames(effort))};
}

}  // namespace warplut
