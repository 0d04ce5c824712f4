#include "tests/golden/golden_scene.h"

#include <cmath>
#include <cstdint>

namespace warplut {
namespace {

constexpr GridSize kRender{24, 18}, kOutput{48, 36};

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

double Wrapped(double x, int period) { return x - period * std::floor(x / period); }

struct Texel {
  float rgb[3];
  float depth;
  float motion[2];  // in pixels of the render grid
};

// A ground that pans, and a nearer square that moves the other way, at a point of the render grid.
Texel TexelAt(double x, double y, int frame) {
  constexpr double kGround[2] = {0.375, -0.25}, kSquare[2] = {-1.5, 0.75};
  // It leaves at one side and comes back at the other.
  const double sx = Wrapped(x - kSquare[0] * frame, kRender.width);
  const double sy = Wrapped(y - kSquare[1] * frame, kRender.height);
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

}  // namespace

ClipFrame GoldenFrame() {
  constexpr PixelFormat kColor = PixelFormat::kRgba32F, kDepth = PixelFormat::kR32F;
  ClipFrame frame;
  frame.color = ImageBuffer(kRender.width, kRender.height, kColor);
  frame.depth = ImageBuffer(kRender.width, kRender.height, kDepth);
  frame.motion = MotionBuffer(kRender.width, kRender.height);
  frame.reference = ImageBuffer(kOutput.width, kOutput.height, kColor);
  frame.reference_depth = ImageBuffer(kOutput.width, kOutput.height, kDepth);
  frame.reference_motion = MotionBuffer(kOutput.width, kOutput.height);
  return frame;
}

void RenderGoldenFrame(int number, ClipFrame& frame) {
  constexpr Vec2 kJitter[4] = {{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}};
  frame.number = number;
  frame.cut = number == 0;
  frame.jitter = kJitter[number % 4];
  Fill(number, 1, frame.jitter, frame.color, frame.depth, frame.motion);
  Fill(number, kOutput.width / kRender.width, {}, frame.reference, frame.reference_depth,
       frame.reference_motion);
}

Clip GoldenClip(int frames) {
  Clip clip;
  clip.name = "golden";
  clip.render = kRender;
  clip.output = kOutput;
  for (int i = 0; i < frames; ++i) RenderGoldenFrame(i, clip.frames.emplace_back(GoldenFrame()));
  return clip;
}

}  // namespace warplut
