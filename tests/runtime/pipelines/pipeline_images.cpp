// pipeline_images NAME: runs a pipeline of kConfigurations over a moving scene, with what the build has of it, and prints for each
// part a line "PART HASH BYTES" of its images and its buffers, or "PART refused: SENTENCE".
#include <cstdio>
#include <cstring>
#include <string>

#include "tests/runtime/pipelines/lean_configurations.h"
#include "tests/runtime/pipelines/moving_scene.h"

namespace warplut {
namespace {

constexpr int kWidth = 150, kHeight = 70;  // larger than a tile
constexpr int kFrames = 6;

template <class T>
void Set(const std::optional<T>& choice, T& option) {
  option = choice.value_or(option);
}

SuperResolutionOptions Configured(const PipelineConfiguration& c, SuperResolutionOptions options) {
  Set(c.sr.form, options.form);
  Set(c.sr.history, options.history);
  Set(c.sr.clamp, options.clamp);
  Set(c.sr.depth, options.depth);
  Set(c.sr.motion, options.motion);
  Set(c.sr.motion_filter, options.motion_filter);
  Set(c.sr.current, options.current);
  Set(c.sr.history_format, options.history_format);
  Set(c.sr.encoding, options.encoding);
  Set(c.filter, options.warp.filter);
  return options;
}

FrameGenerationOptions Configured(const PipelineConfiguration& c, FrameGenerationOptions options) {
  Set(c.generation.motion_model, options.motion_model);
  Set(c.generation.splat, options.splat);
  Set(c.generation.refine, options.refine);
  Set(c.generation.fill, options.fill);
  Set(c.generation.depth, options.depth);
  Set(c.generation.brightness_gate, options.brightness_gate);
  Set(c.generation.motion_filter, options.motion_filter);
  Set(c.generation.encoding, options.encoding);
  Set(c.filter, options.warp.filter);
  return options;
}

// FNV-1a over the images that are added.
class Hash {
 public:
  void Add(const ImageView& image) {
    for (int y = 0; y < image.height; ++y) {
      const auto* row = image.Row<std::uint8_t>(y);
      for (int i = 0; i < image.width * BytesPerPixel(image.format); ++i) {
        value_ = (value_ ^ row[i]) * 0x100000001B3u;
      }
    }
  }
  void Print(const char* part, std::size_t bytes) const {
    std::printf("%s %016llx %zu\n", part, static_cast<unsigned long long>(value_), bytes);
  }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

void RunSuperResolution(const PipelineConfiguration& configuration) {
  SuperResolutionOptions options = Configured(configuration, SuperResolutionOptions{});
  options.render_width = kWidth;
  options.render_height = kHeight;
  options.output_width = 2 * kWidth;
  options.output_height = 2 * kHeight;
  std::string why;
  if (!options.IsValid(&why)) {
    std::printf("super_resolution refused: %s\n", why.c_str());
    return;
  }
  SerialExecutor executor;
  SuperResolution sr(options, executor);
  MovingScene scene(kWidth, kHeight);
  ImageBuffer out(2 * kWidth, 2 * kHeight, PixelFormat::kRgba8);
  Hash hash;
  for (int i = 0; i < kFrames; ++i) {
    scene.Render(i);
    sr.Process(scene.Rendered(), out.view());
    hash.Add(out.view());
  }
  hash.Print("super_resolution", sr.MemoryBytes());
}

template <bool kInterpolates>
void RunGeneration(const PipelineConfiguration& configuration) {
  FrameGenerationOptions options = Configured(configuration, FrameGenerationOptions{});
  options.width = kWidth;
  options.height = kHeight;
  const char* part = kInterpolates ? "interpolation" : "extrapolation";
  std::string why;
  if (!options.IsValid(&why)) {
    std::printf("%s refused: %s\n", part, why.c_str());
    return;
  }
  SerialExecutor executor;
  FrameGeneration generation(options, executor);
  MovingScene scenes[2] = {{kWidth, kHeight}, {kWidth, kHeight}};
  ImageBuffer out(kWidth, kHeight, PixelFormat::kRgba8);
  Hash hash;
  scenes[0].Render(0);
  for (int i = 1; i < kFrames; ++i) {
    scenes[i % 2].Render(i);
    const DisplayedFrame before = scenes[(i + 1) % 2].Displayed();
    const DisplayedFrame now = scenes[i % 2].Displayed();
    if constexpr (kInterpolates) {
      generation.Interpolate(before, now, 0.4f, out.view());
    } else {
      generation.Extrapolate(before, now, 0.4f, out.view());
    }
    hash.Add(out.view());
  }
  hash.Print(part, generation.MemoryBytes());
}

}  // namespace
}  // namespace warplut

int main(int argc, char** argv) {
  using namespace warplut;
  if (argc != 2) return 2;
  for (const auto& [name, configuration] : kConfigurations) {
    if (std::strcmp(name, argv[1]) != 0) continue;
    if constexpr (kPipeline.super_resolution) {
      if (configuration.super_resolution) RunSuperResolution(configuration);
    }
    if constexpr (kPipeline.interpolation) {
      if (configuration.interpolation) RunGeneration<true>(configuration);
    }
    if constexpr (kPipeline.extrapolation) {
      if (configuration.extrapolation) RunGeneration<false>(configuration);
    }
    return 0;
  }
  return 2;
}
