// Super resolution on a GPU: frames of 160 x 90 samples with jitter become frames of 320 x 180
// pixels. Prints how good the last is, and what each pass took. With an argument "gles" the GPU is
// that of OpenGL ES, otherwise that of Vulkan.
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/example/scene.h"
#include "runtime/gpu/gpu_super_resolution.h"
#include "runtime/image_buffer.h"

namespace {

int Run(warplut::GpuApi api) {
  using namespace warplut;
  constexpr int kFrames = 24;
  const Table table(baked::kWarplutIirX2);
  SuperResolutionOptions options;
  options.render_width = 160;
  options.render_height = 90;
  options.output_width = 320;
  options.output_height = 180;
  options.warp = {.filter = Filter::kLut, .table = &table};

  const std::unique_ptr<GpuDevice> device = OpenGpuDevice(api);  // the first one that computes
  std::string why;
  if (!options.IsValid(&why) || !GpuSuperResolution::IsRunnable(*device, options, &why)) {
    std::fprintf(stderr, "%s\n", why.c_str());
    return 1;
  }
  GpuSuperResolution super_resolution(*device, options);
  ImageBuffer shown(options.output_width, options.output_height, PixelFormat::kRgba8);
  example::Scene scene(options.render_width, options.render_height, options.output_width,
                       options.output_height);
  for (int i = 0; i < kFrames; ++i) {
    super_resolution.Process(scene.Render(i), shown);  // colour, depth, motion, jitter
  }
  std::printf("super resolution on %s, frame %d: PSNR %.2f dB\n", device->name().c_str(),
              kFrames - 1, example::Psnr(shown, scene.Reference(kFrames - 1)));
  for (const PassTime& time : super_resolution.Times())
    std::printf("  %-18s %8.3f ms\n", time.pass.c_str(), time.milliseconds);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const bool is_gles = count > 1 && std::strcmp(arguments[1], "gles") == 0;
    return Run(is_gles ? warplut::GpuApi::kGles : warplut::GpuApi::kVulkan);
  } catch (const warplut::GpuError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
