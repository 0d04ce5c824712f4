// The built-in scenes, ray traced: frames with an exact reference, depth, motion and jitter, for
// any size and upscale factor. Nothing is read from disk.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/frame.h"

namespace warplut {

enum class SceneUse {
  kTraining,
  kHeldOut,  // for tests of what was trained on the others
  kFault,    // for one fault of pictures alone: in neither set
};

// As a selection of scenes names it: training, held-out, fault.
std::string_view Name(SceneUse use);

struct SceneInfo {
  std::string_view name;
  std::string_view purpose;
  SceneUse use = SceneUse::kTraining;
};

// All built-in scenes, in a fixed order.
std::span<const SceneInfo> Scenes();

struct RenderOptions {
  int width = 960;  // of the output grid
  int height = 540;
  double scale = 2;        // output / render, 1 to 8; the render grid is rounded to whole pixels
  int frames = 12;         // a scene with camera cuts spreads its takes over them
  double rate = 30;        // frames per second, 1 to 1000
  int samples = 16;        // per pixel of the reference
  std::uint64_t seed = 1;  // varies placement, textures and sample positions
  int threads = 0;         // at most; 0: one per core. The pixels do not depend on it
  bool reference = true;   // the streams of the output grid
  bool inputs = true;      // the streams of the render grid
  bool linear = false;     // colour is linear HDR, else display values
  double exposure = 1;     // factor on the light, (0, 1000]

  // On false, *why (may be null) is a sentence that names the field.
  bool IsValid(std::string* why) const;
};

// The standard deviation of the reference's pixel filter, a Gaussian, in pixels. A box is sharper
// than what games show: engines resolve with filters of 2 to 4 pixels (Karis 2014 uses a Gaussian
// fitted to a Blackman-Harris window of 3.3). This width gives the detail of real game frames, see
// docs/SCENES.md.
inline constexpr double kPixelFilterSigma = 0.60;

// One traced sample, in the units of the streams of the output grid (SceneRenderer).
struct SceneSample {
  std::array<float, 3> color{};
  float depth = 1;
  std::array<float, 2> motion{};
};

// The ray that a mirror in place of a surface reflects, in view space: x right, y down, z the
// depth, scene units. It begins over the surface by the width of a pixel at its depth.
struct SceneReflection {
  bool is_surface = false;  // false: the sky is seen, and nothing is reflected
  std::array<double, 3> origin{}, direction{};
  bool is_hit = false;      // false: the ray meets the sky
  bool is_visible = false;  // the camera sees what the ray hits, from the same side
  Vec2 position;            // of that, in pixels of the output grid; where it is visible
};

// Renders the frames of one scene.
//
// reference   mean of `samples` samples that are distributed as the pixel filter, each tone-mapped
//             to display values before the mean, as a resolved, temporally antialiased frame is.
//             Linear: mean with the weights ToneMapFactor (datasets/tone_map.h), which is that of
//             samples tone-mapped so, brought back.
// color       one sample per pixel, at (i + 0.5 + x, j + 0.5 + y) of the render grid with (x, y)
//             the jitter. Textures are as detailed as on the output grid (mip bias).
// depth       view depth over the far plane; of the mirror's surface where a mirror is seen; sky 1.
//             Of the same sample as color on the render grid, of the pixel centre on the output
//             grid.
// motion      where depth is; exact to float rounding, also for the sky and for what a mirror shows
//             (one bounce). Frame 0 has the motion since the time of a frame before it, at which
//             every scene is defined; 0 at a cut. What was behind the previous camera gets
//             (2 width, 2 height): a previous position outside the image.
class SceneRenderer {
 public:
  // Throws Error when no scene has this name (the sentence lists those that exist) or the options
  // are invalid.
  SceneRenderer(const std::string& scene_name, const RenderOptions& options);
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  // Frame `index`, 0 <= index < frames, else throws Error. Frames are independent: any order, any
  // thread.
  Frame Render(int index) const;

  // Traces frame `index` at these positions of the output grid, in pixels, and nowhere else: sample
  // i is that of positions[i], color one sample as on the render grid.
  std::vector<SceneSample> Trace(int index, std::span<const Vec2> positions) const;

  // The reflections about the normals of the surfaces (without their relief) at these positions of
  // the output grid, in frame `index`.
  std::vector<SceneReflection> Reflect(int index, std::span<const Vec2> positions) const;

  const RenderOptions& options() const;
  int render_width() const;
  int render_height() const;
  // One jitter cycle, JitterCycle(scale) of datasets/jitter.h. Frame f uses offset f modulo the
  // length.
  std::vector<Vec2> Jitter() const;
  // Frames that share nothing with the one before.
  std::vector<int> Cuts() const;
  Camera CameraAt(int frame) const;
  double near_plane() const;  // scene units
  double far_plane() const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace warplut
