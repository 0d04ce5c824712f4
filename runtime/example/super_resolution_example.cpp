// Super resolution: frames of 160 x 90 samples with jitter become frames of 320 x 180 pixels.
#include <cstdio>
#include <string>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"
#include "scene.h"

int main() {
  using namespace warplut;
  constexpr int kFrames = 24;
  const Table table(baked::kWarplutIirX2);  // outlives the objects that use it
  SuperResolutionOptions options;
  options.render_width = 160;
  options.render_height = 90;
  options.output_width = 320;
  options.output_height = 180;
  options.warp = {.filter = Filter::kLut, .table = &table};
  std::string why;
  if (!options.IsValid(&why)) {
    std::fprintf(stderr, "%s\n", why.c_str());
    return 1;
  }

  ThreadPool executor;
  SuperResolution super_resolution(options, executor);  // allocates every buffer
  ImageBuffer shown(options.output_width, options.output_height, PixelFormat::kRgba8);
  example::Scene scene(options.render_width, options.render_height, options.output_width,
                       options.output_height);
  for (int i = 0; i < kFrames; ++i) {
    const RenderedFrame frame = scene.Render(i);  // colour, depth, motion, jitter
    if (!super_resolution.IsProcessable(frame, shown, &why)) {
      std::fprintf(stderr, "%s\n", why.c_str());
      return 1;
    }
    super_resolution.Process(frame, shown);
  }
  std::printf("super resolution, frame %d: PSNR %.2f dB\n", kFrames - 1,
              example::Psnr(shown, scene.Reference(kFrames - 1)));
}
