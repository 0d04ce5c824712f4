#include "tests/golden/golden_hashes.h"

#include <hwy/highway.h>

#include <stdexcept>
#include <utility>

#include "datasets/hash.h"
#include "luts/bake/bake.h"
#include "luts/quantize/baked_table.h"
#include "luts/quantize/quantize.h"
#include "runtime/executor.h"
#include "runtime/warp.h"
#include "tests/golden/golden_scene.h"
#include "tests/luts/test_fits.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

constexpr int kFrames = 6;

std::string HashOfMode(const Clip& clip, const MethodInfo& method, const Table& table) {
  ModeRunOptions options;
  options.method = &method;
  options.shown_format = PixelFormat::kRgba32F;
  options.super_resolution.warp = options.generation.warp = {
      .filter = Filter::kLut, .table = &table, .lookup = Lookup::kBilinear};
  std::string why;
  if (!options.IsValid(clip, &why)) throw std::runtime_error(why);
  SerialExecutor executor;
  std::string bytes;
  RunMode(clip, options, executor, [&](const ShownFrame& frame) {
    for (int y = 0; y < frame.image.height; ++y) {
      const auto* row = reinterpret_cast<const char*>(frame.image.Row<float>(y));
      bytes.append(row, sizeof(float) * 4 * static_cast<std::size_t>(frame.image.width));
    }
  });
  return Sha1(bytes);
}

Fit WideFit(Footprint footprint) {
  Fit fit = MakeFit(0.05);
  fit.footprint = footprint;
  fit.kaiser_b = 4.5;
  fit.parameters.resize(static_cast<std::size_t>(MlpParameters(footprint)), 0.01);
  return fit;
}

}  // namespace

GoldenHashes BakeHashes() {
  const std::pair<const char*, Fit> fits[] = {{"16", MakeFit(0.05)},
                                              {"16-prefilter", WithPrefilter(MakeFit(0.05))},
                                              {"24", WideFit(Footprint::k24)},
                                              {"36", WideFit(Footprint::k36)}};
  GoldenHashes hashes;
  for (const TableFormat format :
       {TableFormat::kI16, TableFormat::kF16, TableFormat::kI8, TableFormat::kF32}) {
    for (const auto& [kind, fit] : fits) {
      // Every kind in the default format, and every format of the default kind.
      if (format != TableFormat::kI16 && &fit != &fits[0].second) continue;
      const BakedFiles files = Bake(fit, {.format = format});
      hashes[std::string("bake/") + Name(format) + "/" + kind] =
          Sha1(files.header + files.json + files.exr);
    }
  }
  return hashes;
}

GoldenHashes ModeHashes() {
  const Clip clip = GoldenClip(kFrames);
  const BakedTable baked = Quantize(SampleFit(MakeFit(0.05), kNodes), TableFormat::kI16);
  const Table table(baked.view());
  GoldenHashes hashes;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    for (const MethodInfo& method : Methods()) {
      hashes[std::string("mode/") + method.name + "/" + WarpTarget()] =
          HashOfMode(clip, method, table);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  return hashes;
}

}  // namespace warplut
