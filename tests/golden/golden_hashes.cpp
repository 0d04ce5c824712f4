#include "tests/golden/golden_hashes.h"

#include <hwy/highway.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "datasets/hash.h"
#include "luts/bake/bake.h"
#include "luts/quantize/baked_table.h"
#include "luts/quantize/quantize.h"
#include "runtime/executor.h"
#include "runtime/warp.h"
#include "tests/luts/test_fits.h"
#include "train/replay/mode_run.h"

namespace warplut {
namespace {

constexpr GridSize kRender{24, 18}, kOutput{48, 36};
constexpr int kFrames = 6;

// In [0, 1), of 8 bits.
double Noise(int x, int y, int channel) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1U +
                    static_cast<std::uint32_t>(y) * 0x85EBCA77U +
                    static_cast<std::uint32_t>(channel) * 0xC2B2AE3DU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return (h >> 24) / 256.0;
}

// Bilinear between noise at multiples of 2; exact, as positions are multiples of 1 / 16.
double Texture(double x, double y, int channel) {
  x /= 2;
  y /= 2;
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const double a = x - i, b = y - j;
  return (1 - b) * ((1 - a) * Noise(i, j, channel) + a * Noise(i + 1, j, channel)) +
         b * ((1 - a) * Noise(i, j + 1, channel) + a * Noise(i + 1, j + 1, channel));
}

struct Texel {
  float rgb[3];
  float depth;
  float motion[2];  // in pixels of the render grid
};

// A ground that pans, and a nearer square that moves the other way, at a point of the render grid.
Texel TexelAt(double x, double y, int frame) {
  constexpr double kGround[2] = {0.375, -0.25}, kSquare[2] = {-1.5, 0.75};
  const double sx = x - kSquare[0] * frame, sy = y - kSquare[1] * frame;
  const bool square = sx >= 12 && sx < 18 && sy >= 4 && sy < 10;
  const double* motion = square ? kSquare : kGround;
  Texel texel = {};
  for (int c = 0; c < 3; ++c) {
    texel.rgb[c] = static_cast<float>(
        Texture(x - motion[0] * frame, y - motion[1] * frame, c + (square ? 3 : 0)));
  }
  texel.depth = square ? 0.25F : 0.75F;
  texel.motion[0] = static_cast<float>(motion[0]);
  texel.motion[1] = static_cast<float>(motion[1]);
  return texel;
}

void Fill(int frame, int scale, Vec2 jitter, ImageBuffer& color, ImageBuffer& depth,
          MotionBuffer& motion) {
  const MutableImageView colors = color.view(), depths = depth.view();
  for (int y = 0; y < colors.height; ++y) {
    for (int x = 0; x < colors.width; ++x) {
      const Texel texel =
          TexelAt((x + 0.5) / scale + jitter.x, (y + 0.5) / scale + jitter.y, frame);
      float* rgba = colors.Row<float>(y) + 4 * x;
      for (int c = 0; c < 3; ++c) rgba[c] = texel.rgb[c];
      rgba[3] = 1;
      depths.Row<float>(y)[x] = texel.depth;
      for (int c = 0; c < 2; ++c) {
        motion.view().Row(y)[2 * x + c] = texel.motion[c] * static_cast<float>(scale);
      }
    }
  }
}

Clip GoldenClip() {
  constexpr Vec2 kJitter[4] = {{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}};
  constexpr PixelFormat kColor = PixelFormat::kRgba32F, kDepth = PixelFormat::kR32F;
  Clip clip;
  clip.name = "golden";
  clip.render = kRender;
  clip.output = kOutput;
  for (int i = 0; i < kFrames; ++i) {
    ClipFrame& frame = clip.frames.emplace_back();
    frame.number = i;
    frame.cut = i == 0;
    frame.jitter = kJitter[i % 4];
    frame.color = ImageBuffer(kRender.width, kRender.height, kColor);
    frame.depth = ImageBuffer(kRender.width, kRender.height, kDepth);
    frame.motion = MotionBuffer(kRender.width, kRender.height);
    frame.reference = ImageBuffer(kOutput.width, kOutput.height, kColor);
    frame.reference_depth = ImageBuffer(kOutput.width, kOutput.height, kDepth);
    frame.reference_motion = MotionBuffer(kOutput.width, kOutput.height);
    Fill(i, 1, frame.jitter, frame.color, frame.depth, frame.motion);
    Fill(i, kOutput.width / kRender.width, {}, frame.reference, frame.reference_depth,
         frame.reference_motion);
  }
  return clip;
}

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
      const BakedFiles files = Bake(fit, {.format = format});
      hashes[std::string("bake/") + Name(format) + "/" + kind] =
          Sha1(files.header + files.json + files.exr);
    }
  }
  return hashes;
}

GoldenHashes ModeHashes() {
  const Clip clip = GoldenClip();
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
