// pipeline_images NAME: runs a pipeline of kConfigurations over a moving scene, with what the build
// has of it, and prints for each part a line "PART HASH BYTES" of its images and its buffers, or
// "PART refused: SENTENCE".
#include <cstdio>
#include <cstring>
#include <string>

#include "runtime/configuration/choice_list.h"
#include "tests/runtime/pipelines/lean_configurations.h"
#include "tests/runtime/pipelines/moving_scene.h"

namespace warplut {
namespace {

constexpr int kWidth = 150, kHeight = 70;  // larger than a tile
constexpr int kFrames = 6;

// The defaults, with the choices that the configuration makes.
template <class Options, class List, class Configuration>
Options Configured(const PipelineConfiguration& whole, const List& list,
                   const Configuration& configuration) {
  Options options;
  ForEachChoice(list, [&](const auto& choice) {
    if (choice.owner == ChoiceOwner::kFrames) return;
    auto& option = options.*choice.option;
    option = (configuration.*choice.configured).value_or(option);
  });
  options.warp.filter = whole.filter.value_or(options.warp.filter);
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
  auto options = Configured<SuperResolutionOptions>(configuration, kSrChoices, configuration.sr);
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
  auto options = Configured<FrameGenerationOptions>(configuration, kGenerationChoices,
                                                    configuration.generation);
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
