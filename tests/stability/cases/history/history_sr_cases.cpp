#include "tests/stability/cases/history/history_sr_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "runtime/executor.h"
#include "runtime/method.h"
#include "runtime/super_resolution.h"
#include "tests/stability/cases/stability_clip.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

constexpr GridSize kRender{12, 9}, kOutput{24, 18};

// Speeds of a pan in pixels of the render grid per frame, not rational.
constexpr double kSpeedX = std::numbers::sqrt2 / 2;
constexpr double kSpeedY = 1 - std::numbers::phi;

int Frames(StabilityEffort effort, int quick) {
  return effort == StabilityEffort::kFull ? 10000 : quick;
}

// One method with one format of history; its last output is RGBA32F.
struct SrRun {
  const MethodInfo* method;
  HistoryForm form;
  PixelFormat format;
  std::unique_ptr<SuperResolution> super_resolution;
  ImageBuffer out;

  void Process(const ClipFrame& frame) { super_resolution->Process(frame.Rendered(), out.view()); }
  std::string Name() const { return fmt::format("{} {}", method->name, warplut::Name(format)); }
};

SerialExecutor& Serial() {
  static SerialExecutor executor;
  return executor;
}

std::vector<SrRun> SrRuns(GridSize render, GridSize output, std::span<const PixelFormat> formats) {
  std::vector<SrRun> runs;
  for (const MethodInfo& method : Methods()) {
    if (!method.super_resolution || method.generation != Generation::kNone) continue;
    for (const PixelFormat format : formats) {
      SuperResolutionOptions options;
      options.render_width = render.width;
      options.render_height = render.height;
      options.output_width = output.width;
      options.output_height = output.height;
      options.history_format = format;
      options.warp = HistoryWarp();
      method.configure_super_resolution(options);
      if (!options.history) continue;
      if (method.paper) options.parameters = kPaperParameters;
      runs.push_back({&method, options.form, format,
                      std::make_unique<SuperResolution>(options, Serial()),
                      ImageBuffer(output.width, output.height, PixelFormat::kRgba32F)});
    }
  }
  return runs;
}

// Other systems promise nothing of the kind: the locks of fsr2 come and go with the jitter
// (docs/METHODS.md).
bool Settles(const SrRun& run) { return !run.method->peer; }

// Two surfaces with noise as their colours; nothing moves.
ClipTexel StillNoise(double x, double y, int picture) {
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  return {.color = {Noise(i, j, 3 * picture), Noise(i, j, 3 * picture + 1),
                    Noise(i, j, 3 * picture + 2)},
          .depth = i < j ? 0.2f : 0.8f};
}

ClipTexel PanningTexture(double x, double y, int frame) {
  ClipTexel texel{.depth = 0.5f, .motion_x = kSpeedX, .motion_y = kSpeedY};
  Texture(x - frame * kSpeedX, y - frame * kSpeedY, 24, texel.color);
  return texel;
}

// What the output moves by in 100 frames after many of a still image.
StabilityResult Settle(int pictures, int frames, std::span<const PixelFormat> formats) {
  constexpr int kWatched = 100;
  ClipFrame frame = MakeClipFrame(kRender, {});
  int moving = 0, count = 0;
  double worst = 0;
  for (int picture = 0; picture < pictures; ++picture) {
    RenderClipFrame(StillNoise, picture, {}, frame);
    for (SrRun& run : SrRuns(kRender, kOutput, formats)) {
      for (int i = 0; i < frames; ++i) run.Process(frame);
      ImageBuffer settled(kOutput.width, kOutput.height, PixelFormat::kRgba32F);
      CopyPixels(run.out.view(), settled.view());
      bool moves = false;
      for (int i = 0; i < kWatched; ++i) {
        run.Process(frame);
        moves = moves || !SameBits(run.out.view(), settled.view());
        worst = std::max(worst, LargestDifference(run.out.view(), settled.view()));
      }
      moving += moves ? 1 : 0;
      ++count;
    }
  }
  return {moving == 0, fmt::format("{} of {} runs still move after {} frames, by at most {:.2g}",
                                   moving, count, frames, worst)};
}

// Root mean square over the interior of the difference of the output from the content, and of the
// content from its mean.
struct Contrast {
  double error = 0, output = 0, content = 0;
};

Contrast MeasureContrast(const ImageView& out, const ImageView& reference) {
  constexpr int kBorder = 8;
  constexpr double kMean = 0.5;
  double error = 0, output = 0, content = 0;
  for (int y = kBorder; y < out.height - kBorder; ++y) {
    for (int x = kBorder; x < out.width - kBorder; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = out.Row<float>(y)[4 * x + c];
        const double wanted = reference.Row<float>(y)[4 * x + c];
        error += (value - wanted) * (value - wanted);
        output += (value - kMean) * (value - kMean);
        content += (wanted - kMean) * (wanted - kMean);
      }
    }
  }
  return {std::sqrt(error), std::sqrt(output), std::sqrt(content)};
}

// Of the residual form alone, or of all others.
StabilityResult Flicker(StabilityEffort effort, bool residual_form) {
  const int pairs = Frames(effort, 2000) / 2;
  ClipFrame frames[2];
  for (int i = 0; i < 2; ++i) {
    frames[i] = MakeClipFrame(kRender, {});
    RenderClipFrame(StillNoise, i, {}, frames[i]);
  }
  double worst_codes = 0, worst = 0, growth = 0;  // of 8-bit histories, of the others
  for (SrRun& run : SrRuns(kRender, kOutput, kColorFormats)) {
    if ((run.form == HistoryForm::kResidual) != residual_form || !Settles(run)) continue;
    double& most = run.format == PixelFormat::kRgba8 ? worst_codes : worst;
    ImageBuffer first(kOutput.width, kOutput.height, PixelFormat::kRgba32F);
    ImageBuffer before(kOutput.width, kOutput.height, PixelFormat::kRgba32F);
    double early_swing = 0, late_swing = 0;
    for (int pair = 0; pair < pairs; ++pair) {
      run.Process(frames[0]);
      CopyPixels(run.out.view(), first.view());
      run.Process(frames[1]);
      late_swing = LargestDifference(run.out.view(), first.view());
      if (pair == 10) early_swing = late_swing;
      const double moved = LargestDifference(run.out.view(), before.view());
      if (pair > 9 * pairs / 10) most = std::max(most, moved);
      CopyPixels(run.out.view(), before.view());
    }
    growth = std::max(growth, late_swing / early_swing);
  }
  return {worst <= kHalfCode && worst_codes <= 2 * kHalfCode && growth <= 1.01,
          fmt::format("from pair to pair after {} {:.2g} of a code value, RGBA8 {:.2g}; swing "
                      "{:.3f} of that of pair 10",
                      9 * pairs / 10, 255 * worst, 255 * worst_codes, growth)};
}

}  // namespace

StabilityResult SrStaticImage(StabilityEffort effort) {
  const int pictures = effort == StabilityEffort::kFull ? 4 : 1;
  constexpr PixelFormat kFormats[] = {PixelFormat::kRgba8, PixelFormat::kRgba16F};
  return Settle(pictures, Frames(effort, 6000), kFormats);
}

StabilityResult SrStaticImageInFloat(StabilityEffort effort) {
  constexpr PixelFormat kFormats[] = {PixelFormat::kRgba32F};
  return Settle(4, Frames(effort, 2000), kFormats);
}

StabilityResult SrJitterCycle(StabilityEffort effort) {
  constexpr int kCycle = 4;
  const int cycles = Frames(effort, 2000) / kCycle;
  ClipFrame frames[kCycle];
  for (int i = 0; i < kCycle; ++i) {
    frames[i] = MakeClipFrame(kRender, {});
    RenderClipFrame(
        [](double x, double y, int) {
          ClipTexel texel = PanningTexture(x, y, 0);
          texel.motion_x = texel.motion_y = 0;
          return texel;
        },
        i, QuarterJitter(i), frames[i]);
  }
  double worst = 0;
  std::string worst_run;
  for (SrRun& run : SrRuns(kRender, kOutput, kColorFormats)) {
    if (!Settles(run)) continue;
    ImageBuffer before(kOutput.width, kOutput.height, PixelFormat::kRgba32F);
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (const ClipFrame& frame : frames) run.Process(frame);
      const double moved = LargestDifference(run.out.view(), before.view());
      if (cycle > 9 * cycles / 10 && moved > worst) {
        worst = moved;
        worst_run = ", " + run.Name();
      }
      CopyPixels(run.out.view(), before.view());
    }
  }
  return {worst <= kHalfCode, fmt::format("{:.2g} of a code value from cycle to cycle after {}{}",
                                          255 * worst, 9 * cycles / 10, worst_run)};
}

StabilityResult SrConstantImage(StabilityEffort effort) {
  constexpr float kColor[3] = {0.2f, 0.6f, 1.0f};  // codes: an 8-bit history holds no others
  const int count = Frames(effort, 500);
  std::vector<SrRun> runs = SrRuns(kRender, kOutput, kColorFormats);
  ClipFrame frame = MakeClipFrame(kRender, {});
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    RenderClipFrame(
        [&](double x, double y, int number) {
          ClipTexel texel = PanningTexture(x, y, number);
          std::copy(std::begin(kColor), std::end(kColor), texel.color);
          return texel;
        },
        i, QuarterJitter(i), frame);
    for (SrRun& run : runs) {
      run.Process(frame);
      const ImageView out = run.out.view();
      for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
          for (int c = 0; c < 3; ++c) {
            worst = std::max(
                worst, static_cast<double>(std::abs(out.Row<float>(y)[4 * x + c] - kColor[c])));
          }
        }
      }
    }
  }
  return {worst <= kHalfCode,
          fmt::format("off by at most {:.2g} of a code value over {} frames", 255 * worst, count)};
}

StabilityResult SrPan(StabilityEffort effort) {
  constexpr GridSize kSmall{24, 20}, kLarge{48, 40};
  constexpr int kWindow = 100;  // frames that early and late are taken over
  const int count = Frames(effort, 600);
  std::vector<SrRun> runs = SrRuns(kSmall, kLarge, kColorFormats);
  std::vector<Contrast> early(runs.size()), late(runs.size());
  ClipFrame frame = MakeClipFrame(kSmall, kLarge);
  const auto add = [](Contrast& sum, const Contrast& one) {
    sum.error += one.error;
    sum.output += one.output;
    sum.content += one.content;
  };
  for (int i = 0; i < count; ++i) {
    RenderClipFrame(PanningTexture, i, QuarterJitter(i), frame);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      runs[r].Process(frame);
      const bool is_early = i >= kWindow && i < 2 * kWindow;
      if (!is_early && i < count - kWindow) continue;
      add(is_early ? early[r] : late[r],
          MeasureContrast(runs[r].out.view(), frame.reference.view()));
    }
  }
  double error = 0, contrast = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    error = std::max(error, late[r].error / late[r].content / (early[r].error / early[r].content));
    contrast = std::max(contrast, late[r].output / late[r].content);
  }
  return {error <= 1.05 && contrast <= 1.05,
          fmt::format("error of the last {} of {} frames {:.3f} of the early one; contrast at most "
                      "{:.3f} of the content's",
                      kWindow, count, error, contrast)};
}

StabilityResult SrFlicker(StabilityEffort effort) { return Flicker(effort, false); }

StabilityResult SrFlickerOfResidualForm(StabilityEffort effort) { return Flicker(effort, true); }

}  // namespace warplut
