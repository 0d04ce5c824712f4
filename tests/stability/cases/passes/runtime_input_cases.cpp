#include "tests/stability/cases/passes/runtime_input_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "runtime/configuration/chosen.h"
#include "runtime/core/pixel.h"
#include "runtime/executor.h"
#include "runtime/motion_filter.h"
#include "tests/stability/cases/passes/runtime_methods.h"
#include "tests/stability/cases/stability_clip.h"

namespace warplut {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr GridSize kInputRender{24, 18}, kInputOutput{48, 36};
constexpr int kInputFrames = 4;

// Every filter that a warp can have.
std::vector<WarpOptions> Warps() {
  std::vector<WarpOptions> warps;
  for (const FilterInfo& info : kFilters) {
    WarpOptions options{.filter = info.filter};
    if (info.needs_table) options.table = &HistoryTable();
    warps.push_back(options);
  }
  return warps;
}

ImageBuffer NoiseImage(int width, int height, PixelFormat format) {
  ImageBuffer image(width, height, format);
  const float white = format == PixelFormat::kRgba8 ? 255.0f : 1.0f;
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < 4 * width; ++i) {
      StoreChannel(format, white * Noise(i, y, 0), image.view().At(0, y), i);
    }
  }
  return image;
}

// An image of the same size whose texels are all that of the lower left corner.
ImageBuffer LowerLeftCorner(const ImageView& image) {
  ImageBuffer corner(image.width, image.height, image.format);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::memcpy(corner.view().At(x, y), image.At(0, image.height - 1),
                  static_cast<std::size_t>(BytesPerPixel(image.format)));
    }
  }
  return corner;
}

MotionBuffer Motion(int width, int height, float x, float y) {
  MotionBuffer motion(width, height);
  for (int row = 0; row < height; ++row) {
    for (int i = 0; i < width; ++i) {
      motion.view().Row(row)[2 * i] = x;
      motion.view().Row(row)[2 * i + 1] = y;
    }
  }
  return motion;
}

float OddMotion(int x, int y, int frame) {
  constexpr float kValues[] = {kNaN,      kInfinity, -kInfinity, 1e6f, -1e6f, kLargest,
                               -kLargest, -0.0f,     1e-40f,     0.5f, 2.25f, -16777216.0f};
  return kValues[static_cast<std::size_t>(Noise(x, y, frame) * std::size(kValues))];
}

// A moving scene with a third of its motion vectors wild.
Clip WildScene(int seed) {
  Clip clip = MovingScene(kInputRender, kInputOutput, kInputFrames);
  EditMotion(clip, [seed](float* xy, int x, int y, int frame) {
    if (Noise(x, y, frame + 100 * seed) > 0.3f) return;
    xy[0] = OddMotion(x, y, frame + 100 * seed + 31);
    xy[1] = OddMotion(x, y, frame + 100 * seed + 62);
  });
  return clip;
}

// Every method on a clip that gives it no motion to go by.
StabilityResult NothingMoves(const std::vector<Clip>& clips) {
  double worst = 0;
  const char* where = "";
  int runs = 0;
  for (const Clip& clip : clips) {
    for (const MethodInfo& method : Methods()) {
      const double difference =
          DifferenceFromStill(clip, method, RunMethod(clip, method), Between::kMean);
      if (difference > worst) where = method.name;
      worst = std::max(worst, difference);
      ++runs;
    }
  }
  return {worst <= kRounding,
          fmt::format("off by at most {:.2g} in {} runs{}{}", worst, runs,
                      worst > kRounding ? ", " : "", worst > kRounding ? where : "")};
}

// The number of methods whose output has other bits on `b` than on `a`.
StabilityResult SameOnBoth(const std::vector<std::pair<Clip, Clip>>& pairs) {
  int runs = 0;
  std::string different;
  for (const auto& [a, b] : pairs) {
    for (const MethodInfo& method : Methods()) {
      ++runs;
      if (!SameBits(RunMethod(a, method), RunMethod(b, method))) {
        different += fmt::format(" {}", method.name);
      }
    }
  }
  return {different.empty(), different.empty() ? fmt::format("the same bits in {} runs", runs)
                                               : "other bits:" + different};
}

}  // namespace

StabilityResult WarpOddMotion(StabilityEffort) {
  constexpr int kWidth = 37, kHeight = 19;
  int runs = 0;
  double worst = 0;
  for (const PixelFormat format : kColorFormats) {
    const ImageBuffer history = NoiseImage(kWidth, kHeight, format);
    ImageBuffer odd(kWidth, kHeight, format), still(kWidth, kHeight, format);
    for (const WarpOptions& options : Warps()) {
      for (const auto& [x, y] : {std::pair{kNaN, 0.4f}, {kInfinity, 0.4f}, {0.4f, -kInfinity}}) {
        const auto number = [](float m) { return std::isfinite(m) ? m : 0.0f; };
        Warp(history.view(), Motion(kWidth, kHeight, x, y).view(), options, odd.view());
        Warp(history.view(), Motion(kWidth, kHeight, number(x), number(y)).view(), options,
             still.view());
        ++runs;
        worst = std::max(worst, LargestDifference(odd.view(), still.view()) / WarpBound(format));
      }
    }
  }
  return {worst <= 1,
          fmt::format("{:.2f} of the bound from the warp with 0 there, {} warps", worst, runs)};
}

StabilityResult WarpFarMotion(StabilityEffort) {
  constexpr int kWidth = 37, kHeight = 19;
  double worst = 0;
  int runs = 0;
  for (const PixelFormat format : kColorFormats) {
    const ImageBuffer history = NoiseImage(kWidth, kHeight, format);
    ImageBuffer far(kWidth, kHeight, format);
    const ImageBuffer corner = LowerLeftCorner(std::as_const(history).view());
    for (const WarpOptions& options : Warps()) {
      for (const float distance : {999999.5f, 1e6f, 16777216.0f, 1e30f, kLargest}) {
        Warp(history.view(), Motion(kWidth, kHeight, distance, -distance).view(), options,
             far.view());
        worst = std::max(worst, LargestDifference(far.view(), corner.view()));
        ++runs;
      }
    }
  }
  return {worst <= kRounding,
          fmt::format("off from the corner's texel by at most {:.2g} in {} warps", worst, runs)};
}

StabilityResult MotionNotFinite(StabilityEffort) {
  std::vector<Clip> clips;
  for (const auto& [mx, my] : {std::pair{kNaN, kNaN}, {kInfinity, 0.0f}, {0.5f, -kInfinity}}) {
    clips.push_back(PanningGround(kInputRender, kInputOutput, kInputFrames));
    EditMotion(clips.back(), [mx = mx, my = my](float* xy, int, int, int) {
      xy[0] = mx;
      xy[1] = my;
    });
  }
  return NothingMoves(clips);
}

StabilityResult MotionOfAMillionPixels(StabilityEffort) {
  Clip clip = PanningGround(kInputRender, kInputOutput, kInputFrames);
  EditMotion(clip, [](float* xy, int, int, int) {
    xy[0] = 1e6f;
    xy[1] = -1e6f;
  });
  double worst = 0, worst_mesh = 0;
  for (const MethodInfo& method : Methods()) {
    const ShownImages shown = RunMethod(clip, method);
    if (method.generation != Generation::kExtrapolation) {
      worst = std::max(worst, DifferenceFromStill(clip, method, shown, Between::kMean));
      continue;
    }
    double& of_kind = IsAnchoredMesh(method) ? worst_mesh : worst;
    // Every pixel left the image: what is shown is as far outside of it, the texel of the lower
    // left corner.
    for (std::size_t i = 1; i < shown.size(); ++i) {
      if (!shown[i].generated) continue;
      const ImageView image = shown[i].image.view();
      const ImageView before = shown[i - 1].image.view();
      const ImageBuffer corner = LowerLeftCorner(before);
      of_kind = std::max(of_kind, LargestDifference(image, corner.view()));
    }
  }
  return {worst <= kRounding && worst_mesh <= kStretchedRounding,
          fmt::format("off by at most {:.2g}, meshes by {:.2g}, {} methods", worst, worst_mesh,
                      Methods().size())};
}

StabilityResult MotionWild(StabilityEffort effort) {
  Examination examination;
  const int clips = effort == StabilityEffort::kFull ? 20 : 2;
  for (int seed = 0; seed < clips; ++seed) {
    examination.Examine(WildScene(seed), fmt::format("wild motion, seed {}", seed));
  }
  return examination.Result();
}

StabilityResult MotionFilterUpsampledWild(StabilityEffort effort) {
  const int clips = effort == StabilityEffort::kFull ? 150 : 30;
  constexpr double kTolerance = 1e-3;  // pixels
  SuperResolutionOptions sr;
  sr.render_width = kInputRender.width;
  sr.render_height = kInputRender.height;
  sr.output_width = kInputOutput.width;
  sr.output_height = kInputOutput.height;
  SerialExecutor executor;
  const MotionFilterOptions options{kGenerationMotionFilterLimit};
  ImageBuffer shown(kInputOutput.width, kInputOutput.height, PixelFormat::kRgba32F);
  MotionBuffer fast(kInputOutput.width, kInputOutput.height),
      plain(kInputOutput.width, kInputOutput.height);
  int differing = 0, frames = 0;
  double worst = 0;
  for (int seed = 0; seed < clips; ++seed) {
    SuperResolution super_resolution(sr, executor);
    for (const ClipFrame& frame : WildScene(seed).frames) {
      super_resolution.Process(frame.Rendered(), shown.view());
      const OutputGeometry geometry = super_resolution.Geometry();
      MotionFilter(kInputOutput.width, kInputOutput.height, options)
          .Apply(geometry.depth, geometry.motion, executor, fast.view());
      MotionFilter::Reference(geometry.depth, geometry.motion, options, plain.view());
      double most = 0;
      for (int y = 0; y < kInputOutput.height; ++y) {
        for (int i = 0; i < 2 * kInputOutput.width; ++i) {
          const float a = fast.view().Row(y)[i], b = plain.view().Row(y)[i];
          if (a != b && !(std::isnan(a) && std::isnan(b))) {
            most = std::max(most, static_cast<double>(std::abs(a - b)));
          }
        }
      }
      worst = std::max(worst, most);
      differing += most > kTolerance ? 1 : 0;
      ++frames;
    }
  }
  return {differing == 0, fmt::format("{} of {} frames differ from the plain version, by at most "
                                      "{:.3g} pixels",
                                      differing, frames, worst)};
}

StabilityResult MotionFilterWild(StabilityEffort) {
  constexpr int kWidth = 96, kHeight = 72;
  constexpr float kWildShare = 0.3f;
  constexpr double kStep = 0.25;  // motion is rounded to multiples
  const CameraMotion camera = {
      .c = {0.01, -0.02, 0.015, 0.0008, 0.02, 0.01, -0.01, 0.0003, 0.006, -0.004, 0.0002}};
  ImageBuffer depth(kWidth, kHeight, PixelFormat::kR32F);
  MotionBuffer motion(kWidth, kHeight), fast(kWidth, kHeight), plain(kWidth, kHeight);
  const auto is_wild = [](int x, int y) { return Noise(x, y, 1) < kWildShare; };
  const auto exact = [&](int x, int y) {
    return camera.At(x, y, InverseDepth(depth.view().Row<float>(y)[x]), kWidth, kHeight);
  };
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      depth.view().Row<float>(y)[x] = 0.01f + 0.2f * Noise(x, y, 0);
      const auto [mx, my] = exact(x, y);
      float* m = motion.view().Row(y) + 2 * x;
      m[0] =
          is_wild(x, y) ? OddMotion(x, y, 2) : static_cast<float>(std::round(mx / kStep) * kStep);
      m[1] =
          is_wild(x, y) ? OddMotion(x, y, 3) : static_cast<float>(std::round(my / kStep) * kStep);
    }
  }
  SerialExecutor executor;
  const MotionFilterOptions options;
  MotionFilter(kWidth, kHeight, options).Apply(depth.view(), motion.view(), executor, fast.view());
  MotionFilter::Reference(depth.view(), motion.view(), options, plain.view());
  double worst = 0, difference = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (is_wild(x, y)) continue;
      const auto [mx, my] = exact(x, y);
      const float* m = fast.view().Row(y) + 2 * x;
      const float* p = plain.view().Row(y) + 2 * x;
      worst = std::max({worst, std::abs(mx - m[0]), std::abs(my - m[1])});
      difference = std::max({difference, static_cast<double>(std::abs(m[0] - p[0])),
                             static_cast<double>(std::abs(m[1] - p[1]))});
    }
  }
  return {
      worst <= kStep / 4 && difference <= 1e-5,
      fmt::format("{:.3f} pixels from exact motion, rounded to {}; {:.2g} from the plain version",
                  worst, kStep, difference)};
}

StabilityResult DepthNotFinite(StabilityEffort) {
  constexpr float kOdd[] = {kNaN, kInfinity, -kInfinity, -1.0f, kLargest};
  std::vector<std::pair<Clip, Clip>> pairs;
  for (const float share : {0.2f, 1.0f}) {
    auto& [odd, far] = pairs.emplace_back();
    odd = MovingScene(kInputRender, kInputOutput, kInputFrames);
    far = MovingScene(kInputRender, kInputOutput, kInputFrames);
    EditDepth(odd, [&](float& depth, int x, int y, int frame) {
      if (Noise(x, y, frame) <= share) depth = kOdd[(x + y + frame) % 5];
    });
    EditDepth(far, [share](float& depth, int x, int y, int frame) {
      if (Noise(x, y, frame) <= share) depth = kFarthestDepth;
    });
  }
  return SameOnBoth(pairs);
}

StabilityResult DepthAllEqual(StabilityEffort) {
  const auto at = [](float value) {
    Clip clip = MovingScene(kInputRender, kInputOutput, kInputFrames);
    EditDepth(clip, [value](float& depth, int, int, int) { depth = value; });
    return clip;
  };
  std::vector<std::pair<Clip, Clip>> pairs;
  for (const float depth : {0.0f, 1e-30f, 1e-3f, 1.0f, 1e5f, kFarthestDepth}) {
    pairs.emplace_back(at(0.5f), at(depth));
  }
  return SameOnBoth(pairs);
}

StabilityResult DepthReversed(StabilityEffort) {
  constexpr GridSize kWideRender{96, 18}, kWideOutput{192, 36};
  constexpr int kMargin =
      // pixels around the object that its depth may reach: motion, taps, boxes, over all frames
      40;
  const Clip right = MovingScene(kWideRender, kWideOutput, kInputFrames);
  Clip wrong = MovingScene(kWideRender, kWideOutput, kInputFrames);
  EditDepth(wrong, [](float& depth, int, int, int) { depth = 1 - depth; });
  Examination examination;
  examination.Examine(wrong, "reversed depth");
  StabilityResult result = examination.Result();
  // What is judged by regions reaches farther (runtime/sr/aliasing.h).
  double worst = 0, worst_by_regions = 0;
  const int object_begin = static_cast<int>(0.3 * kWideOutput.width) - kMargin;
  const int object_end = static_cast<int>(0.7 * kWideOutput.width) + kMargin;
  for (const MethodInfo& method : Methods()) {
    SuperResolutionOptions form;
    if (method.super_resolution) method.configure_super_resolution(form);
    const bool by_regions = method.super_resolution && SmoothsAliasing(form);
    double& off = by_regions ? worst_by_regions : worst;
    const ShownImages a = RunMethod(right, method), b = RunMethod(wrong, method);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto columns = [&](const ShownImage& shown, int begin, int end) {
        ImageView view = shown.image.view();
        view.data = view.At(begin, 0);
        view.width = end - begin;
        return view;
      };
      off = std::max(
          {off, LargestDifference(columns(a[i], 0, object_begin), columns(b[i], 0, object_begin)),
           LargestDifference(columns(a[i], object_end, kWideOutput.width),
                             columns(b[i], object_end, kWideOutput.width))});
    }
  }
  // The depth decides which tiles have uniform motion, and so which kernel warps them. Both sum the
  // same 16 products, the one for uniform motion column by column, that for general motion in 4, 2
  // or 1 partial sums (vectors of 16, 8 or 4 floats). The sums differ by a few 2^-24 with every
  // instruction set that has vectors, and one half in some thousands rounds to its neighbour. Which
  // ones do depends on the order, so that some sets may show none of them on this content.
  constexpr double kHalfUnit = 0x1p-11;  // in [1/2, 1)
  result.passed = result.passed && worst <= kHalfUnit && worst_by_regions <= kHalfCode;
  result.observed +=
      fmt::format("; far from the object off by {:.2g}, in the adaptive form by {:.2g}", worst,
                  worst_by_regions);
  return result;
}

StabilityResult ColorNotFinite(StabilityEffort) {
  constexpr float kOdd[] = {kNaN, kInfinity, -kInfinity, -1.0f, 1e30f, kLargest};
  Clip clip = MovingScene(kInputRender, kInputOutput, kInputFrames);
  EditColor(clip, [&](float* rgba, int x, int y, int frame) {
    if (Noise(x, y, frame) > 0.1f) return;
    rgba[(x + frame) % 3] = kOdd[(x + y) % 6];
  });
  Examination examination;
  examination.Examine(clip, "odd colours");
  return examination.Result();
}

}  // namespace warplut
