#include "tools/report/budget/budget_super_resolution.h"

#include <algorithm>
#include <cmath>

#include "tools/judge/sequence_scores.h"
#include "tools/report/budget/budget_images.h"
#include "tools/report/budget/budget_motion.h"
#include "train/replay/image_views.h"

namespace warplut {
namespace {

// Super resolution over a clip, frame by frame.
class Loop {
 public:
  Loop(const Clip& clip, const SuperResolutionOptions& options, Executor& executor)
      : clip_(clip),
        super_resolution_(options, executor),
        shown_(options.output_width, options.output_height, PixelFormat::kRgba32F) {}

  Image Process(std::size_t frame) {
    super_resolution_.Process(clip_.frames[frame].Rendered(), shown_.view());
    return JudgedImage(shown_.view(), clip_.encoding);
  }
  MotionView UpsampledMotion() { return super_resolution_.Geometry().motion; }

 private:
  const Clip& clip_;
  SuperResolution super_resolution_;
  ImageBuffer shown_;
};

// The share of a new sample at each output pixel, as the residual form has it.
Image SampleShares(const Clip& clip, const ClipFrame& frame, const Parameters& parameters) {
  Image shares(clip.output.width, clip.output.height, 1);
  const auto distance = [](int pixel, int output, int render, double jitter) {
    const double sample = (pixel + 0.5) * render / output - 0.5 - jitter;
    return sample - std::clamp(std::round(sample), 0.0, render - 1.0);
  };
  for (int y = 0; y < shares.height; ++y) {
    const double dy = distance(y, clip.output.height, clip.render.height, frame.jitter.y);
    for (int x = 0; x < shares.width; ++x) {
      const double dx = distance(x, clip.output.width, clip.render.width, frame.jitter.x);
      const float weight = SampleWeight(parameters.blend_b, static_cast<float>(std::hypot(dx, dy)));
      shares.at(x, y) = BlendShare(parameters.blend_a, weight);
    }
  }
  return shares;
}

PixelMask Revealed(const ClipFrame& frame, const ClipFrame& before) {
  const FrameGeometry now = ReferenceGeometry(frame), then = ReferenceGeometry(before);
  PixelMask revealed(static_cast<std::size_t>(now.motion.width) * now.motion.height);
  for (int y = 0; y < now.motion.height; ++y) {
    for (int x = 0; x < now.motion.width; ++x) {
      revealed[static_cast<std::size_t>(y) * now.motion.width + x] =
          WasVisible(now, then, x, y) ? 0 : 1;
    }
  }
  return revealed;
}

// Pixels that are not in `revealed` and whose shading changed.
PixelMask Changed(const Image& warped, const Image& reference, const PixelMask& revealed) {
  PixelMask visible(revealed.size());
  for (std::size_t p = 0; p < visible.size(); ++p) visible[p] = revealed[p] == 0;
  const Image error = LocalLumaError(warped, reference, visible);
  PixelMask changed(revealed.size());
  for (std::size_t p = 0; p < changed.size(); ++p) {
    changed[p] = visible[p] != 0 && std::abs(error.data[p]) > kShadingChange;
  }
  return changed;
}

// O, or what is nearer to the reference between the current frame and the history; the reference
// where `truth` is set.
Image BestOf(const Image& shown, const Image& current, const Image& history, const Image& reference,
             int radius, const PixelMask& truth) {
  Image best = shown;
  TakeNearer(BestBlend(current, history, reference, radius), reference, radius, best);
  CopyMasked(reference, truth, best);
  return best;
}

}  // namespace

const BudgetPlan& SuperResolutionPlan() {
  static const BudgetPlan kPlan = {
      {{"motion in halves", "motion in two bytes"},
       {"motion in two bytes", "the renderer's exact motion"},
       {"disocclusion", "the reference, where the frame before did not show the surface"},
       {"shading change", "the reference, where a visible surface changed its shading"},
       {"blend", "the best share of history for the 9 x 9 pixels around each"},
       {"blend of single pixels", "the best share of history at every pixel"},
       {"motion between samples", "the exact motion of every output pixel"},
       {"samples", "history from a loop whose samples are those of the reference"}},
      {"resampling", "the repeated warps of that loop"}};
  return kPlan;
}

ErrorBudget SuperResolutionBudget(const Clip& clip, const SuperResolutionOptions& options,
                                  Executor& executor) {
  SuperResolutionOptions alone = options;
  alone.history = false;
  const Clip halves = WithStoredMotion(clip, MotionStorage::kHalf);
  const Clip bytes = WithStoredMotion(clip, MotionStorage::kBytes);
  Loop halves_loop(halves, options, executor), bytes_loop(bytes, options, executor);
  Loop exact_loop(clip, options, executor), current_loop(clip, alone, executor);

  BudgetSum sum(clip.name);
  Image last, last_reference, ideal;
  for (std::size_t f = 0; f < clip.frames.size(); ++f) {
    const ClipFrame& frame = clip.frames[f];
    const Image reference = JudgedImage(frame.reference.view(), clip.encoding);
    const Image shown = exact_loop.Process(f);
    const Image by_halves = halves_loop.Process(f);
    const Image by_bytes = bytes_loop.Process(f);
    const Image current = current_loop.Process(f);
    if (f == 0 || frame.cut) {
      ideal = reference;
    } else {
      const MotionView motion = frame.reference_motion.view();
      PixelMask truth = Revealed(frame, clip.frames[f - 1]);
      Image visible = shown;
      CopyMasked(reference, truth, visible);
      const PixelMask changed =
          Changed(WarpedImage(last_reference, motion, options.warp), reference, truth);
      for (std::size_t p = 0; p < truth.size(); ++p) truth[p] |= changed[p];
      Image unchanged = shown;
      CopyMasked(reference, truth, unchanged);

      const Image upsampled = WarpedImage(last, exact_loop.UpsampledMotion(), options.warp);
      const Image moved = WarpedImage(last, motion, options.warp);
      const Image around = BestOf(shown, current, upsampled, reference, kBlendRadius, truth);
      const Image single = BestOf(shown, current, upsampled, reference, 0, truth);
      const Image exact = BestOf(shown, current, moved, reference, 0, truth);

      ideal = WarpedImage(ideal, motion, options.warp);
      const Image shares = SampleShares(clip, frame, options.parameters);
      for (std::size_t i = 0; i < ideal.data.size(); ++i) {
        ideal.data[i] += shares.data[i / 3] * (reference.data[i] - ideal.data[i]);
      }
      CopyMasked(reference, truth, ideal);
      sum.Add(
          {&by_halves, &by_bytes, &shown, &visible, &unchanged, &around, &single, &exact, &ideal},
          reference);
    }
    last = shown;
    last_reference = reference;
  }
  return sum.Finish();
}

}  // namespace warplut
