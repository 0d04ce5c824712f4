// Sparks that no motion describes, under super resolution with a reactive mask; and a HUD over a
// panning scene, under frame generation: as a layer of its own and burned into the frames.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/executor.h"
#include "runtime/frame_generation.h"
#include "runtime/hud.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"
#include "scene.h"

namespace {

using namespace warplut;
constexpr int kWidth = 320, kHeight = 180, kScale = 2;

// How much of a spark covers output position (x, y) at a time, in [0, 1]: 24 discs that rise, their
// edges soft over two pixels.
float Spark(double x, double y, double time) {
  double most = 0;
  for (int i = 0; i < 24; ++i) {
    const double column = 30 + 11 * i + 6 * std::sin(i + 0.3 * time);
    const double row = kHeight - std::fmod(67.0 * i + (3 + i % 4) * time, kHeight);
    most = std::fmax(most, 0.5 * (6 - std::hypot(x - column, y - row)));
  }
  return static_cast<float>(std::fmin(most, 1));
}

// Adds the sparks to an image of which pixel (x, y) shows output position
// ((x + 0.5 + jitter_x) scale, (y + 0.5 + jitter_y) scale); `mask` gets what they cover, if given.
void AddSparks(double time, double scale, double jitter_x, double jitter_y,
               const MutableImageView& image, const MutableImageView& mask) {
  constexpr float kColor[3] = {1.0f, 0.8f, 0.3f};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const float spark = Spark((x + 0.5 + jitter_x) * scale, (y + 0.5 + jitter_y) * scale, time);
      for (int c = 0; c < 3; ++c) {
        const float behind = example::Load(image, x, y, c);
        example::Store(image, x, y, c, behind + spark * (kColor[c] - behind));
      }
      if (mask.data != nullptr) mask.Row<float>(y)[x] = spark > 0 ? 1.0f : 0.0f;
    }
  }
}

ImageBuffer Copy(const ImageView& from) {
  ImageBuffer to(from.width, from.height, from.format);
  const int bytes = from.width * BytesPerPixel(from.format);
  for (int y = 0; y < from.height; ++y) std::memcpy(to.view().At(0, y), from.At(0, y), bytes);
  return to;
}

// PSNR of the last of 16 frames.
double Upscale(bool with_mask) {
  constexpr int kFrames = 16;
  const Table table(baked::kWarplutIirX2);
  SuperResolutionOptions options;
  options.render_width = kWidth / kScale;
  options.render_height = kHeight / kScale;
  options.output_width = kWidth;
  options.output_height = kHeight;
  options.warp = {.filter = Filter::kLut, .table = &table};
  options.reactive = with_mask;
  ThreadPool executor;
  SuperResolution super_resolution(options, executor);
  example::Scene scene(kWidth / kScale, kHeight / kScale, kWidth, kHeight);
  ImageBuffer mask(kWidth / kScale, kHeight / kScale, PixelFormat::kR32F);
  ImageBuffer shown(kWidth, kHeight, PixelFormat::kRgba8);
  for (int i = 0; i < kFrames; ++i) {
    RenderedFrame frame = scene.Render(i);
    ImageBuffer color = Copy(frame.color);
    AddSparks(i, kScale, frame.jitter_x, frame.jitter_y, color, mask);
    frame.color = color.view();
    if (with_mask) frame.reactive = mask.view();  // 1 where a spark covers the sample
    super_resolution.Process(frame, shown);
  }
  ImageBuffer reference = Copy(scene.Reference(kFrames - 1));
  AddSparks(kFrames - 1, 1, 0, 0, reference, {});
  return example::Psnr(shown, reference);
}

// "12:47" in white at the middle of a dark bar, half transparent; premultiplied.
ImageBuffer MakeHud() {
  constexpr int kGlyphs[5][5] = {
      {2, 6, 2, 2, 7}, {6, 1, 2, 4, 7}, {0, 2, 0, 2, 0}, {5, 5, 7, 1, 1}, {7, 1, 2, 2, 2}};
  ImageBuffer hud(kWidth, kHeight, PixelFormat::kRgba8);
  for (int y = 80; y < 100; ++y) {
    for (int x = 120; x < 200; ++x) {
      const int column = (x - 130) / 3, row = (y - 83) / 3;
      const bool is_text = x >= 130 && y >= 83 && column < 20 && row < 5 && column % 4 < 3 &&
                           (kGlyphs[column / 4][row] >> (2 - column % 4) & 1) != 0;
      for (int c = 0; c < 4; ++c) {
        example::Store(hud, x, y, c, is_text ? 1.0f : c == 3 ? 0.5f : 0.0f);
      }
    }
  }
  return hud;
}

// PSNR of the frame half way between two of the moving scene, with the HUD.
double Interpolate(bool as_layer) {
  FrameGenerationOptions options;
  options.width = kWidth;
  options.height = kHeight;
  ThreadPool executor;
  FrameGeneration generation(options, executor);
  const ImageBuffer hud = MakeHud();
  example::Scene scene(kWidth, kHeight, kWidth, kHeight);
  ImageBuffer colors[2], depths[2];
  MotionBuffer motions[2] = {{kWidth, kHeight}, {kWidth, kHeight}};
  DisplayedFrame frames[2];
  for (int i = 0; i < 2; ++i) {
    const RenderedFrame rendered = scene.Render(4 + 4 * i);
    depths[i] = Copy(rendered.depth);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < 2 * kWidth; ++x) {
        motions[i].view().Row(y)[x] = 4 * rendered.motion.Row(y)[x];  // of four frames
      }
    }
    colors[i] = Copy(scene.Reference(4 + 4 * i));
    if (!as_layer) DrawHud(hud, ColorEncoding::kDisplay, executor, colors[i]);
    frames[i] = {.color = colors[i].view(), .depth = depths[i].view(), .motion = motions[i].view()};
    if (as_layer) frames[i].hud = hud.view();
  }
  ImageBuffer between(kWidth, kHeight, PixelFormat::kRgba8);
  generation.Interpolate(frames[0], frames[1], 0.5f, between);
  ImageBuffer reference = Copy(scene.Reference(6));
  DrawHud(hud, ColorEncoding::kDisplay, executor, reference);
  return example::Psnr(between, reference);
}

}  // namespace

int main() {
  std::printf("sparks without a mask: PSNR %.2f dB\n", Upscale(false));
  std::printf("with a reactive mask: PSNR %.2f dB\n", Upscale(true));
  std::printf("HUD in the frames: PSNR %.2f dB\n", Interpolate(false));
  std::printf("HUD as a layer: PSNR %.2f dB\n", Interpolate(true));
}
