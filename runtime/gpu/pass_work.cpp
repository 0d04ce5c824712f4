#include "runtime/gpu/pass_work.h"

#include <algorithm>

#include "runtime/configuration/chosen.h"
#include "runtime/prefilter.h"
#include "runtime/sr/aliasing.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

constexpr double kTexel = 8;        // RGBA16F
constexpr double kScalar = 4;       // R32F
constexpr double kTileLength = 64;  // of shaders/prefilter.comp

// The prefilter of an image of `pixels`, columns and rows.
void AppendPrefilter(const WarpOptions& warp, double pixels, std::vector<PassWork>* work) {
  const Prefilter prefilter = PrefilterOf(warp);
  if (!HasPrefilter(prefilter)) return;
  const double overlap = 1 + 2 * PrefilterReach(prefilter) / kTileLength;
  // Forward and backward: a difference, a product and a sum for each of three channels.
  const double operations =
      prefilter.kind == PrefilterKind::kRecursive ? 2 * 3 * 3 * overlap : prefilter.reach * 3 * 4;
  for (const char* name : {"prefilter columns", "prefilter rows"})
    work->push_back({name, pixels, overlap, operations, kTexel * overlap + kTexel});
}

// One warp: the weights, then the taps.
struct WarpWork {
  double fetches, operations;
};
WarpWork WorkOfWarp(const WarpOptions& warp) {
  const bool table = FilterOf(warp) == Filter::kLut;
  const double taps = TapCount(FootprintOf(warp));
  const double nodes = LookupOf(warp) == Lookup::kBilinear ? 4 : 1;
  const double weights = table ? (nodes > 1 ? 7 * taps : 0) + 4 * taps : 60;
  return {(table ? taps / 4 * nodes : 0) + taps, weights + 2 * 4 * taps};
}

}  // namespace

std::vector<PassWork> WorkOf(const SuperResolutionOptions& options, const InputBytes& inputs) {
  const double output = 1.0 * options.output_width * options.output_height;
  const double render = 1.0 * options.render_width * options.render_height;
  const double area = output / render;
  const double tile = 1.0 * kAliasingTile * kAliasingTile;
  std::vector<PassWork> work;
  AppendPrefilter(options.warp, output, &work);
  work.push_back({"samples", render, 9, 162, inputs.color + 2 * kTexel});

  // Depth and motion of 4 samples, the range of depths, boxes, then the table and its taps.
  const WarpWork warp = WorkOfWarp(options.warp);
  const double predict_fetches = 4 + 4 + 2 + 8 + warp.fetches;
  const double predict_operations = warp.operations + 60 + 40 + 25 + 42;
  const double render_bytes = inputs.depth + inputs.motion + 2 * kTexel + 2 * kScalar;
  work.push_back({"predict", output, predict_fetches, predict_operations,
                  kTexel + render_bytes / area + kTexel});
  work.push_back(
      {"residual", render, 17, 177, inputs.color + kTexel * area + kTexel + kScalar / tile});
  work.push_back({"aliasing", render / tile, 25, 66, 2 * kScalar});
  const double shown = EncodingOf(options) == ColorEncoding::kLinearHdr ? kTexel : 0;
  work.push_back({"update", output, 1 + 4 + 4, 90, kTexel + kTexel / area + kTexel + shown});
  work.push_back({"depth range", render, 17, 66, inputs.depth + 2 * kScalar});
  return work;
}

std::vector<PassWork> WorkOf(const FrameGenerationOptions& options, bool interpolates,
                             const InputBytes& inputs) {
  constexpr double kKey = 8, kWord = 4;
  // A displacement and its nearest pixel: depth and motion of the pixel and of the four around its
  // place in frame 0; both nearest pixels, the place and its weights, the four, the surface, the
  // path.
  constexpr double kForwardFetches = 2 + 4 * 2, kForward = 2 * 6 + 14 + 4 * 16 + 12 + 32;
  const double pixels = 1.0 * options.width * options.height;
  const double frames = interpolates ? 2 : 1;
  std::vector<PassWork> work;
  AppendPrefilter(options.warp, pixels, &work);
  work.push_back({"fill", pixels, 0, 0, kKey});
  // Motion and depth of both frames; an atomic reads and writes its word.
  const double moving = 2.0 * (inputs.motion + inputs.depth);
  work.push_back({"splat depth", pixels, kForwardFetches, kForward, moving + 2 * kWord});
  work.push_back({"splat source", pixels, kForwardFetches + 1, kForward, moving + 3 * kWord});
  // The depths of 9 arrivals, the displacement of one, the depths around both sources, the blend.
  const WarpWork warp = WorkOfWarp(options.warp);
  const double share_fetches = interpolates ? 2 * 9 : 0;
  const double share_operations = interpolates ? 2 * 9 * 3 + 40 : 0;
  work.push_back({interpolates ? "interpolate" : "extrapolate", pixels,
                  9 + 1 + kForwardFetches + share_fetches + frames * warp.fetches,
                  9 * 6 + kForward + share_operations + frames * (warp.operations + 20),
                  kKey + moving + frames * kTexel + kTexel});
  return work;
}

PassWork NineTapWarp(const SuperResolutionOptions& options) {
  const double output = 1.0 * options.output_width * options.output_height;
  return {"Catmull-Rom, 9 fetches", output, 9 + 1, 9 * 4 * 2 + 40, kTexel + 4 + kTexel};
}

double RooflineMilliseconds(const PassWork& work, double bytes_per_second,
                            double operations_per_second) {
  return 1000 * work.pixels *
         std::max(work.bytes / bytes_per_second, work.operations / operations_per_second);
}

}  // namespace warplut
