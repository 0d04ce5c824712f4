#include "tools/report/budget/budget_generation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/judge/sequence_scores.h"
#include "tools/report/budget/budget_images.h"
#include "tools/report/budget/budget_motion.h"
#include "tools/report/report_inputs.h"
#include "train/replay/image_views.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

static_assert(kReportEvery == 2, "the generated frame lies one frame from each rendered one");
constexpr float kAlpha = 0.5f;

// One source of a generated frame, warped to it by exact motion, and where it shows the surface.
struct Source {
  Image image;
  PixelMask visible;
};

Image Warped(const Clip& clip, int frame, const MotionView& motion, const WarpOptions& filter) {
  const ImageView reference = clip.frames[static_cast<std::size_t>(frame)].reference.view();
  return WarpedImage(JudgedImage(reference, clip.encoding), motion, filter);
}

// The frame before, by the motion of the generated one.
Source Before(const Clip& clip, int frame, const WarpOptions& filter) {
  const FrameGeometry now = ReferenceGeometry(clip.frames[static_cast<std::size_t>(frame)]);
  const FrameGeometry before = ReferenceGeometry(clip.frames[static_cast<std::size_t>(frame - 1)]);
  Source source{Warped(clip, frame - 1, now.motion, filter), {}};
  for (int y = 0; y < now.motion.height; ++y) {
    for (int x = 0; x < now.motion.width; ++x) {
      source.visible.push_back(WasVisible(now, before, x, y) ? 1 : 0);
    }
  }
  return source;
}

// The frame after, by the motion from the generated one to it.
Source After(const Clip& clip, int frame, const WarpOptions& filter) {
  ForwardMotion forward =
      ForwardMotionOf(ReferenceGeometry(clip.frames[static_cast<std::size_t>(frame)]),
                      ReferenceGeometry(clip.frames[static_cast<std::size_t>(frame + 1)]));
  return {Warped(clip, frame + 1, forward.motion.view(), filter), std::move(forward.known)};
}

Image Middle(Image a, const Image& b) {
  for (std::size_t i = 0; i < a.data.size(); ++i) a.data[i] += kAlpha * (b.data[i] - a.data[i]);
  return a;
}

// Pixels whose surface is shown by the one and not by the other, as the two values say.
PixelMask Where(const Source& before, bool by_before, const Source& after, bool by_after) {
  PixelMask mask(before.visible.size());
  for (std::size_t p = 0; p < mask.size(); ++p) {
    mask[p] = (before.visible[p] != 0) == by_before && (after.visible[p] != 0) == by_after;
  }
  return mask;
}

// Pixels at which no blend of the sources that show the surface has the local luma of the
// reference.
PixelMask ShadingChanged(const Source& before, const Source& after, const Image& reference) {
  const Image a = LocalLumaError(before.image, reference, before.visible);
  const Image b = LocalLumaError(after.image, reference, after.visible);
  PixelMask changed(before.visible.size(), 0);
  for (std::size_t p = 0; p < changed.size(); ++p) {
    const bool sees_a = before.visible[p] != 0, sees_b = after.visible[p] != 0;
    if (!sees_a && !sees_b) continue;
    const float first = sees_a ? a.data[p] : b.data[p];
    const float second = sees_b ? b.data[p] : a.data[p];
    changed[p] = first * second > 0 && std::min(std::abs(first), std::abs(second)) > kShadingChange;
  }
  return changed;
}

// What the method generates, by index in the clip.
std::map<int, Image> Generated(const Clip& sparse, const char* method,
                               const FrameGenerationOptions& options, Executor& executor) {
  std::map<int, Image> images;
  ModeRunOptions run;
  run.method = FindMethod(method);
  run.every = kReportEvery;
  run.alphas = {kAlpha};
  run.generation = options;
  RunMode(sparse, run, executor, [&](const ShownFrame& shown) {
    if (!IsJudged(*run.method, shown)) return;
    images.emplace(shown.frame, JudgedImage(shown.image, sparse.encoding));
  });
  return images;
}

}  // namespace

const BudgetPlan& GenerationPlan(Generation generation) {
  static const BudgetCause kHalves = {"motion in halves", "motion in two bytes"};
  static const BudgetCause kBytes = {"motion in two bytes", "the exact motion of rendered frames"};
  static const BudgetCause kHidden = {"disocclusion",
                                      "the reference, where no source shows the surface"};
  static const BudgetCause kOneSided = {
      "one source", "the source that shows the surface, by exact motion, where it is one of two"};
  static const BudgetCause kTarget = {"motion of the frame",
                                      "the sources by exact motion of the generated frame itself"};
  static const BudgetCause kShading = {
      "shading change", "the reference, where no blend of the sources has its local luma"};
  static const BudgetCause kBlend = {"blend of single pixels",
                                     "the best share of either source at every pixel"};
  static const BudgetCause kResampling = {"resampling", "one warp of each source by exact motion"};
  static const BudgetPlan kInterpolation = {
      {kHalves, kBytes, kHidden, kOneSided, kTarget, kShading, kBlend}, kResampling};
  static const BudgetPlan kExtrapolation = {{kHalves, kBytes, kHidden, kTarget, kShading},
                                            kResampling};
  return generation == Generation::kExtrapolation ? kExtrapolation : kInterpolation;
}

ErrorBudget GenerationBudget(const Clip& dense, const Clip& sparse, Generation generation,
                             const FrameGenerationOptions& options, Executor& executor) {
  const bool extrapolates = generation == Generation::kExtrapolation;
  const char* const method = extrapolates ? "e" : "i";
  const std::map<int, Image> exact = Generated(sparse, method, options, executor);
  const auto stored = [&](MotionStorage storage) {
    return Generated(WithStoredMotion(sparse, storage), method, options, executor);
  };
  const std::map<int, Image> halves = stored(MotionStorage::kHalf);
  const std::map<int, Image> bytes = stored(MotionStorage::kBytes);

  BudgetSum sum(dense.name);
  for (const auto& [frame, shown] : exact) {
    const auto f = static_cast<std::size_t>(frame);
    if (dense.frames[f].cut || (!extrapolates && dense.frames[f + 1].cut)) continue;
    const Image reference = JudgedImage(dense.frames[f].reference.view(), dense.encoding);
    const Source before = Before(dense, frame, options.warp);
    const Source after = extrapolates ? before : After(dense, frame, options.warp);
    PixelMask truth = Where(before, false, after, false);
    const PixelMask both = Where(before, true, after, true);
    Image found = shown;
    CopyMasked(reference, truth, found);
    Image one_sided = found;
    CopyMasked(before.image, Where(before, true, after, false), one_sided);
    CopyMasked(after.image, Where(before, false, after, true), one_sided);
    Image moved = one_sided;
    CopyMasked(Middle(before.image, after.image), both, moved);
    const PixelMask changed = ShadingChanged(before, after, reference);
    for (std::size_t p = 0; p < truth.size(); ++p) truth[p] |= changed[p];
    Image unchanged = moved;
    CopyMasked(reference, truth, unchanged);
    Image best = moved;
    CopyMasked(BestBlend(before.image, after.image, reference, 0), both, best);
    CopyMasked(reference, truth, best);

    std::vector<const Image*> rungs = {&halves.at(frame), &bytes.at(frame), &shown, &found};
    if (!extrapolates) rungs.push_back(&one_sided);
    rungs.insert(rungs.end(), {&moved, &unchanged});
    if (!extrapolates) rungs.push_back(&best);
    sum.Add(rungs, reference);
  }
  return sum.Finish();
}

}  // namespace warplut
