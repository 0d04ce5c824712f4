#include "datasets/scenes/scene_renderer.h"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/error.h"
#include "datasets/jitter.h"
#include "datasets/scenes/builtin.h"
#include "datasets/scenes/hash.h"
#include "datasets/scenes/integrator.h"
#include "datasets/tone_map.h"

namespace warplut {
namespace {

using scenes::Integrator;
using scenes::Path;
using scenes::Vec2d;

// Motion below this many pixels is rounding.
constexpr double kNoMotion = 1e-6;
constexpr int kSmallest = 8, kLargest = 16384;

int RenderSize(int output, double scale) { return static_cast<int>(std::lround(output / scale)); }

// Sample `index` of the (0, 2)-sequence in [0, 1)^2, its digits flipped by the hash of the pixel.
Vec2d SubPixel(std::uint32_t index, std::uint32_t pixel) {
  std::uint32_t x = 0, y = 0, bit = 1U << 31, direction = 1U << 31;
  for (std::uint32_t n = index; n != 0; n >>= 1, bit >>= 1, direction ^= direction >> 1) {
    if (n & 1) {
      x ^= bit;
      y ^= direction;
    }
  }
  return {(x ^ pixel) * 0x1p-32, (y ^ scenes::Hash(pixel)) * 0x1p-32};
}

// Where in the image sample `index` of pixel (x, y) lies: drawn from the pixel filter, so that the
// plain mean of the samples is the filtered value.
Vec2d SamplePosition(int x, int y, std::uint32_t index, std::uint32_t pixel) {
  const Vec2d u = SubPixel(index, pixel);
  const double radius = kPixelFilterSigma * std::sqrt(-2 * std::log(1 - u.x()));
  const double angle = 2 * std::numbers::pi * u.y();
  return {x + 0.5 + radius * std::cos(angle), y + 0.5 + radius * std::sin(angle)};
}

std::size_t FindScene(const std::string& name) {
  std::string names;
  const auto all = Scenes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
    names += (i == 0 ? "" : ", ") + std::string(all[i].name);
  }
  throw Error("scene \"" + name + "\" does not exist; the built-in scenes are " + names);
}

const RenderOptions& Checked(const RenderOptions& options) {
  std::string why;
  if (!options.IsValid(&why)) throw Error(why);
  return options;
}

// Displacement since the frame before, in pixels of a grid of this size, of what is seen at the
// position.
std::array<float, 2> Motion(const Integrator& integrator, const Path& path, const Vec2d& position,
                            const Vec2d& size, bool cut) {
  if (cut) return {};
  const auto previous = integrator.Previous(path);
  Vec2d m = previous ? (position - *previous).cwiseProduct(size).eval() : (2 * size).eval();
  if (m.cwiseAbs().maxCoeff() < kNoMotion) m.setZero();
  return {static_cast<float>(m.x()), static_cast<float>(m.y())};
}

// Depth and motion of one pixel, in the units of Frame.
void Store(const Integrator& integrator, const Path& path, const Vec2d& position, bool cut, int x,
           int y, Image& depth, Image& motion) {
  depth.at(x, y) = integrator.Depth(path);
  const auto m = Motion(integrator, path, position, Vec2d(motion.width, motion.height), cut);
  motion.at(x, y, 0) = m[0];
  motion.at(x, y, 1) = m[1];
}

scenes::Rgb Colour(const Integrator& integrator, const RenderOptions& options, const Path& path) {
  const scenes::Rgb exposed =
      scenes::Exposed(integrator.Radiance(path), static_cast<float>(options.exposure));
  return options.linear ? exposed : scenes::DisplayCurve(exposed);
}

void RenderRow(const Integrator& integrator, const RenderOptions& options, int y, Frame& frame) {
  Image& image = frame.reference;
  const double width = image.width, height = image.height;
  for (int x = 0; x < image.width; ++x) {
    const auto pixel = scenes::Hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                    static_cast<std::uint32_t>(options.seed));
    scenes::Rgb sum(0, 0, 0);
    float weights = 0;
    for (int i = 0; i < options.samples; ++i) {
      const Vec2d at = SamplePosition(x, y, static_cast<std::uint32_t>(i), pixel);
      const scenes::Rgb sample =
          Colour(integrator, options, integrator.Follow({at.x() / width, at.y() / height}));
      const float weight = options.linear ? ToneMapFactor(sample.maxCoeff()) : 1.0f;
      sum += weight * sample;
      weights += weight;
    }
    sum /= weights;
    for (int c = 0; c < 3; ++c) image.at(x, y, c) = sum[c];
    const Vec2d centre((x + 0.5) / width, (y + 0.5) / height);
    Store(integrator, integrator.Follow(centre), centre, frame.cut, x, y, frame.reference_depth,
          frame.reference_motion);
  }
}

void RenderInputRow(const Integrator& integrator, const RenderOptions& options, int y,
                    Frame& frame) {
  Image& image = frame.color;
  for (int x = 0; x < image.width; ++x) {
    const Vec2d at((x + 0.5 + frame.jitter.x) / image.width,
                   (y + 0.5 + frame.jitter.y) / image.height);
    const Path path = integrator.Follow(at);
    const scenes::Rgb colour = Colour(integrator, options, path);
    for (int c = 0; c < 3; ++c) image.at(x, y, c) = colour[c];
    Store(integrator, path, at, frame.cut, x, y, frame.depth, frame.motion);
  }
}

}  // namespace

bool RenderOptions::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& sentence) {
    if (why != nullptr) *why = "render options: " + sentence;
    return false;
  };
  const auto range = [](const char* field, auto value, auto low, auto high) {
    return std::string(field) + " is " + std::to_string(value) + ", expected " +
           std::to_string(low) + " to " + std::to_string(high);
  };
  if (width < kSmallest || width > kLargest)
    return fail(range("width", width, kSmallest, kLargest));
  if (height < kSmallest || height > kLargest)
    return fail(range("height", height, kSmallest, kLargest));
  if (!(scale >= 1 && scale <= 8)) return fail(range("scale", scale, 1, 8));
  if (frames < 1 || frames > 100000) return fail(range("frames", frames, 1, 100000));
  if (!(rate >= 1 && rate <= 1000)) return fail(range("rate", rate, 1, 1000));
  if (samples < 1 || samples > 65536) return fail(range("samples", samples, 1, 65536));
  if (threads < 0 || threads > 1024) return fail(range("threads", threads, 0, 1024));
  if (!(exposure > 0 && exposure <= 1000)) return fail(range("exposure", exposure, 0, 1000));
  if (!reference && !inputs)
    return fail("neither reference nor inputs is wanted, expected at least one");
  return true;
}

struct SceneRenderer::State {
  State(std::size_t scene, const RenderOptions& wanted)
      : options(wanted), world(scenes::Builders()[scene](wanted.seed)), tracer(world) {}

  int Shot(int frame) const {
    return static_cast<int>(static_cast<long long>(frame) * world.shots / options.frames);
  }
  bool Cut(int frame) const { return frame > 0 && Shot(frame) != Shot(frame - 1); }
  double Aspect() const { return static_cast<double>(options.width) / options.height; }

  scenes::Lens LensAt(int frame) const {
    return {world.camera(Time(frame), Shot(frame)), Aspect(), world.near_plane, world.far_plane};
  }
  double Time(int frame) const { return frame * FrameSeconds(); }
  double FrameSeconds() const { return 1 / options.rate; }

  // Throws Error when there is no such frame.
  void CheckFrame(int index) const {
    if (index >= 0 && index < options.frames) return;
    throw Error("frame index is " + std::to_string(index) + ", expected 0 to " +
                std::to_string(options.frames - 1));
  }
  // The output grid's pixel on both grids: for the inputs a mip bias of log2(1 / scale).
  Integrator IntegratorAt(int frame) const {
    return Integrator(world, tracer, Time(frame), FrameSeconds(), Shot(frame), Aspect(),
                      LensAt(frame).PixelAngle(options.height));
  }
  // Calls each(i) for 0 <= i < count, runs of them on one thread.
  template <class Each>
  void ForEachSample(std::size_t count, const Each& each) const {
    constexpr std::size_t kRun = 256;
    ForEachRow(static_cast<int>((count + kRun - 1) / kRun), [&](int run) {
      const std::size_t begin = static_cast<std::size_t>(run) * kRun;
      for (std::size_t i = begin; i < std::min(begin + kRun, count); ++i) each(i);
    });
  }
  // Calls row(y) for 0 <= y < rows on the threads of the options.
  template <class Row>
  void ForEachRow(int rows, const Row& row) const {
    const int cores = oneapi::tbb::info::default_concurrency();
    oneapi::tbb::task_arena arena(options.threads == 0 ? cores : std::min(options.threads, cores));
    arena.execute([&] { oneapi::tbb::parallel_for(0, rows, row); });
  }

  RenderOptions options;
  scenes::World world;
  scenes::Tracer tracer;
};

SceneRenderer::SceneRenderer(const std::string& scene_name, const RenderOptions& options)
    : state_(std::make_unique<const State>(FindScene(scene_name), Checked(options))) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

const RenderOptions& SceneRenderer::options() const { return state_->options; }
int SceneRenderer::render_width() const {
  return RenderSize(state_->options.width, state_->options.scale);
}
int SceneRenderer::render_height() const {
  return RenderSize(state_->options.height, state_->options.scale);
}
double SceneRenderer::near_plane() const { return state_->world.near_plane; }
double SceneRenderer::far_plane() const { return state_->world.far_plane; }
Camera SceneRenderer::CameraAt(int frame) const { return state_->LensAt(frame).Matrices(); }

std::vector<Vec2> SceneRenderer::Jitter() const { return JitterCycle(state_->options.scale); }

std::vector<int> SceneRenderer::Cuts() const {
  std::vector<int> cuts;
  for (int f = 1; f < state_->options.frames; ++f) {
    if (state_->Cut(f)) cuts.push_back(f);
  }
  return cuts;
}

Frame SceneRenderer::Render(int index) const {
  const RenderOptions& options = state_->options;
  state_->CheckFrame(index);
  Frame frame;
  frame.number = index;
  frame.cut = state_->Cut(index);
  const auto jitter = Jitter();
  frame.jitter = jitter[index % jitter.size()];
  frame.camera = CameraAt(index);
  const Integrator integrator = state_->IntegratorAt(index);
  if (options.reference) {
    frame.reference = Image(options.width, options.height, 3);
    frame.reference_depth = Image(options.width, options.height, 1);
    frame.reference_motion = Image(options.width, options.height, 2);
  }
  if (options.inputs) {
    frame.color = Image(render_width(), render_height(), 3);
    frame.depth = Image(render_width(), render_height(), 1);
    frame.motion = Image(render_width(), render_height(), 2);
  }
  state_->ForEachRow(frame.reference.height,
                     [&](int y) { RenderRow(integrator, options, y, frame); });
  state_->ForEachRow(frame.color.height,
                     [&](int y) { RenderInputRow(integrator, options, y, frame); });
  return frame;
}

std::vector<SceneSample> SceneRenderer::Trace(int index, std::span<const Vec2> positions) const {
  const RenderOptions& options = state_->options;
  state_->CheckFrame(index);
  const Integrator integrator = state_->IntegratorAt(index);
  const Vec2d size(options.width, options.height);
  const bool cut = state_->Cut(index);
  std::vector<SceneSample> samples(positions.size());
  state_->ForEachSample(positions.size(), [&](std::size_t i) {
    const Vec2d at = Vec2d(positions[i].x, positions[i].y).cwiseQuotient(size);
    const Path path = integrator.Follow(at);
    const scenes::Rgb colour = Colour(integrator, options, path);
    samples[i] = {{colour[0], colour[1], colour[2]},
                  integrator.Depth(path),
                  Motion(integrator, path, at, size, cut)};
  });
  return samples;
}

std::vector<SceneReflection> SceneRenderer::Reflect(int index,
                                                    std::span<const Vec2> positions) const {
  const RenderOptions& options = state_->options;
  state_->CheckFrame(index);
  const Integrator integrator = state_->IntegratorAt(index);
  const scenes::Lens lens = state_->LensAt(index);
  const Vec2d size(options.width, options.height);
  std::vector<SceneReflection> reflections(positions.size());
  state_->ForEachSample(positions.size(), [&](std::size_t i) {
    const auto traced =
        integrator.Reflect(Vec2d(positions[i].x, positions[i].y).cwiseQuotient(size));
    if (!traced) return;
    SceneReflection& reflection = reflections[i];
    const auto stored = [](const scenes::Vec3d& v) {
      return std::array<double, 3>{v.x(), v.y(), v.z()};
    };
    reflection.is_surface = true;
    reflection.origin = stored(lens.ToView(traced->origin - lens.eye()));
    reflection.direction = stored(lens.ToView(traced->direction));
    reflection.is_hit = traced->hit.object >= 0;
    reflection.is_visible = traced->is_visible;
    if (!traced->is_visible) return;
    const Vec2d at = lens.Project(traced->point)->cwiseProduct(size);
    reflection.position = {at.x(), at.y()};
  });
  return reflections;
}

}  // namespace warplut
