#include "tests/stability/cases/passes/runtime_time_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "runtime/executor.h"
#include "tests/stability/cases/passes/runtime_methods.h"
#include "tests/stability/cases/stability_clip.h"

namespace warplut {
namespace {

constexpr GridSize kTimeRender{24, 18}, kTimeOutput{48, 36};
constexpr int kTimeFrames = 4;

// One generating method with its buffers.
struct FrameMaker {
  explicit FrameMaker(const MethodInfo& info, GridSize grid, bool reference = false,
                      int threads = 1)
      : method(info), pool(threads), out(grid.width, grid.height, PixelFormat::kRgba32F) {
    FrameGenerationOptions options;
    options.width = grid.width;
    options.height = grid.height;
    options.warp = HistoryWarp();
    options.reference = reference;
    method.configure_generation(options);
    if (method.paper) options.parameters = kPaperParameters;
    generation = std::make_unique<FrameGeneration>(options, pool);
  }

  ImageView Generate(const ClipFrame& frame0, const ClipFrame& frame1, float alpha) {
    if (method.generation == Generation::kInterpolation) {
      generation->Interpolate(frame0.Displayed(), frame1.Displayed(), alpha, out.view());
    } else {
      generation->Extrapolate(frame0.Displayed(), frame1.Displayed(), alpha, out.view());
    }
    return out.view();
  }

  const MethodInfo& method;
  ThreadPool pool;
  std::unique_ptr<FrameGeneration> generation;
  ImageBuffer out;
};

// The methods that warp displayed frames.
std::vector<const MethodInfo*> GeneratingMethods() {
  std::vector<const MethodInfo*> methods;
  for (const MethodInfo& method : Methods()) {
    if (method.configure_generation != nullptr && !method.super_resolution) {
      methods.push_back(&method);
    }
  }
  return methods;
}

// Whether what lay farther counts for nothing, as what lay nearer does: not in super resolution,
// but the paper's.
bool RejectsFarther(const MethodInfo& method) { return !method.super_resolution || method.paper; }

// Every method, or those that are chosen, whose history or motion counts for nothing on this clip.
StabilityResult ShowsNoHistory(const Clip& clip, Between between, const MethodSetup& setup = {},
                               bool (*chosen)(const MethodInfo&) = nullptr) {
  double worst = 0;
  std::size_t count = 0;
  std::string where;
  for (const MethodInfo& method : Methods()) {
    if (chosen != nullptr && !chosen(method)) continue;
    ++count;
    const double difference =
        DifferenceFromStill(clip, method, RunMethod(clip, method, setup), between);
    if (difference > worst) where = method.name;
    worst = std::max(worst, difference);
  }
  std::string observed = fmt::format("off by at most {:.2g}, {} methods", worst, count);
  if (worst > kRounding) observed += ", most with " + where;
  return {worst <= kRounding, observed};
}

// Nothing moves; the depth is the same everywhere, depth(frame).
template <class Depth>
Clip JumpingDepth(const Depth& depth) {
  Clip clip = PanningGround(kTimeRender, kTimeOutput, kTimeFrames);
  EditMotion(clip, [](float* xy, int, int, int) { xy[0] = xy[1] = 0; });
  EditDepth(clip, [&](float& z, int, int, int frame) { z = depth(frame); });
  return clip;
}

// As ShowsNoHistory, where the depth grows by `factor` from frame to frame; where it grows and
// falls in turn, those that reject what lay farther too.
StabilityResult ShowsNoHistoryOfOtherDepth(float first, float factor,
                                           const MethodSetup& setup = {}) {
  const auto growing = [=](int frame) {
    return first * std::pow(factor, static_cast<float>(frame));
  };
  const auto alternating = [=](int frame) { return frame % 2 == 0 ? first : first * factor; };
  const StabilityResult all = ShowsNoHistory(JumpingDepth(growing), Between::kFarther, setup);
  const StabilityResult both_ways =
      ShowsNoHistory(JumpingDepth(alternating), Between::kFarther, setup, RejectsFarther);
  return {all.passed && both_ways.passed,
          fmt::format("growing depth: {}; in turn: {}", all.observed, both_ways.observed)};
}

}  // namespace

StabilityResult AlphaOutside(StabilityEffort) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Clip clip = MovingScene(kTimeRender, kTimeOutput, 2);
  int refused = 0, tried = 0;
  std::string sentence;
  for (const MethodInfo* method : GeneratingMethods()) {
    FrameMaker generator(*method, kTimeOutput);
    for (const float alpha : {0.0f, 1.0f, -0.0f, -1e-6f, 1.5f, kNaN, kInfinity, -kInfinity}) {
      std::string why;
      const bool accepted =
          generator.generation->IsGenerable(clip.frames[0].Displayed(), clip.frames[1].Displayed(),
                                            alpha, generator.out.view(), &why);
      ++tried;
      refused += !accepted && why.find("alpha") != std::string::npos ? 1 : 0;
      if (alpha == 0) sentence = why;
    }
  }
  return {refused == tried, fmt::format("{} of {} refused: \"{}\"", refused, tried, sentence)};
}

StabilityResult AlphaNearTheEnds(StabilityEffort) {
  constexpr float kNear = 1e-6f;
  constexpr double kEdges =
      0.02;  // share of pixels at edges of objects, whose splatted positions are rounded
  const Clip ground = PanningGround(kTimeRender, kTimeOutput, 2);
  const Clip scene = MovingScene(kTimeRender, kTimeOutput, 2);
  double worst = 0, edges = 0;
  for (const MethodInfo* method : GeneratingMethods()) {
    // Other systems promise none of this.
    if (method->peer || method->optical_flow) continue;
    const bool interpolates = method->generation == Generation::kInterpolation;
    for (const Clip* clip : {&ground, &scene}) {
      const ClipFrame& frame0 = clip->frames[0];
      const ClipFrame& frame1 = clip->frames[1];
      FrameMaker begin(*method, kTimeOutput), end(*method, kTimeOutput),
          before_end(*method, kTimeOutput);
      begin.Generate(frame0, frame1, kNear);
      end.Generate(frame0, frame1, 1 - kNear);
      before_end.Generate(frame0, frame1, 1 - 2 * kNear);
      const ImageView begin_wanted =
          interpolates ? frame0.reference.view() : frame1.reference.view();
      const ImageView end_wanted = interpolates ? frame1.reference.view() : before_end.out.view();
      for (const auto& [made, wanted] :
           {std::pair{&begin, begin_wanted}, std::pair{&end, end_wanted}}) {
        const ImageView image = made->out.view();
        edges = std::max(edges, DifferingShare(image, wanted, kHalfCode));
        if (clip == &ground) worst = std::max(worst, LargestDifference(image, wanted));
      }
    }
  }
  return {
      worst <= kHalfCode && edges <= kEdges,
      fmt::format("one surface: off by at most {:.2g} of a code value; with an object: {:.2g} of "
                  "the pixels off by more than half of one",
                  255 * worst, edges)};
}

StabilityResult EmptyHistory(StabilityEffort) {
  const Clip clip = MovingScene(kTimeRender, kTimeOutput, kTimeFrames);
  int different = 0, count = 0;
  for (const MethodInfo& method : Methods()) {
    if (!method.super_resolution || method.configure_generation != nullptr) continue;
    const ShownImages shown = RunMethod(clip, method);
    const ShownImages expected = RunMethod(clip, WithoutHistory(method));
    ++count;
    if (!SameBits(shown[0].image.view(), expected[0].image.view())) ++different;
  }
  return {different == 0, fmt::format("{} of {} methods differ", different, count)};
}

StabilityResult CutInEachFrame(StabilityEffort) {
  Clip clip = MovingScene(kTimeRender, kTimeOutput, kTimeFrames);
  for (ClipFrame& frame : clip.frames) frame.cut = true;
  return ShowsNoHistory(clip, Between::kLater);
}

StabilityResult AllDisoccluded(StabilityEffort) { return ShowsNoHistoryOfOtherDepth(0.1f, 2.0f); }

StabilityResult AllGatesShut(StabilityEffort) {
  Parameters shut;
  for (const ParameterInfo& info : kParameters) {
    if (std::string_view(info.name).ends_with("threshold")) shut.*info.member = info.min;
  }
  return ShowsNoHistoryOfOtherDepth(0.5f, 1.02f, {.parameters = shut});
}

StabilityResult EqualDepthTies(StabilityEffort) {
  // Two bars at one depth, the upper moving down and the lower up, that meet in the generated
  // frame.
  constexpr GridSize kGrid{64, 48};
  constexpr float kUpper[3] = {0.9f, 0.2f, 0.1f}, kLower[3] = {0.1f, 0.3f, 0.8f};
  constexpr int kUpperRow = 10, kLowerRow = 26, kBarRows = 6, kSpeed = 16;
  Clip clip = MakeClip(kGrid, kGrid, 2, [&](double, double y, int) {
    ClipTexel texel{.color = {0.5f, 0.5f, 0.5f}, .depth = 0.9f};
    const auto bar = [&](int row, const float(&color)[3], double motion) {
      if (y < row || y >= row + kBarRows) return;
      std::copy(std::begin(color), std::end(color), texel.color);
      texel.depth = 0.4f;
      texel.motion_y = motion;
    };
    bar(kUpperRow, kUpper, kSpeed);
    bar(kLowerRow, kLower, -kSpeed);
    return texel;
  });
  int wrong = 0, other_bits = 0, runs = 0;
  for (const char* name : {"e", "e-paper"}) {
    const MethodInfo& method = *FindMethod(name);
    FrameMaker first(method, kGrid);
    const ImageView shown = first.Generate(clip.frames[0], clip.frames[1], 0.5f);
    for (int y = kUpperRow + kSpeed / 2; y < kUpperRow + kSpeed / 2 + kBarRows; ++y) {
      for (int x = 0; x < kGrid.width; ++x) {
        const float* pixel = shown.Row<float>(y) + 4 * x;
        wrong += std::equal(std::begin(kUpper), std::end(kUpper), pixel) ? 0 : 1;
      }
    }
    for (const bool reference : {false, true}) {
      for (const int threads : {1, 2, 5}) {
        FrameMaker other(method, kGrid, reference, threads);
        ++runs;
        if (!SameBits(shown, other.Generate(clip.frames[0], clip.frames[1], 0.5f))) ++other_bits;
      }
    }
  }
  return {wrong == 0 && other_bits == 0,
          fmt::format("{} pixels show the other object; {} of {} runs have other bits", wrong,
                      other_bits, runs)};
}

StabilityResult EqualDepthOverlap(StabilityEffort) {
  Clip clip = MovingScene(kTimeRender, kTimeOutput, kTimeFrames);
  EditDepth(clip, [](float& depth, int, int, int) { depth = 0.5f; });
  Examination examination;
  examination.Examine(clip, "two objects of one depth");
  return examination.Result();
}

}  // namespace warplut
