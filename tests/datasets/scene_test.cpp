#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "datasets/error.h"
#include "datasets/scenes/scene_renderer.h"
#include "datasets/srgb_curve.h"

namespace warplut {
namespace {

RenderOptions Small() {
  RenderOptions options;
  options.width = 64;
  options.height = 36;
  options.samples = 4;
  return options;
}

std::string WhyInvalid(const RenderOptions& options) {
  std::string why;
  EXPECT_FALSE(options.IsValid(&why));
  EXPECT_FALSE(options.IsValid(nullptr));
  return why;
}

std::string ErrorOf(const std::string& scene, const RenderOptions& options, int frame = 0) {
  try {
    SceneRenderer(scene, options).Render(frame);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Scenes, AreNamedOnceAndSplitByScene) {
  std::set<std::string_view> names;
  int training = 0, held_out = 0, fault = 0;
  for (const SceneInfo& scene : Scenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_FALSE(scene.purpose.empty()) << scene.name;
    ++(scene.use == SceneUse::kTraining  ? training
       : scene.use == SceneUse::kHeldOut ? held_out
                                         : fault);
  }
  EXPECT_GE(training, 4);
  EXPECT_GE(held_out, 2);
  EXPECT_GE(fault, 2);
}

// The ACES fit of K. Narkowicz, then the sRGB curve.
float Displayed(float x) {
  return SrgbCurve(std::min(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 1.0f));
}

// A sample of a display frame is that of a linear one through the display curve.
TEST(Scenes, LinearFramesAreWhatTheDisplayCurveGets) {
  RenderOptions options = Small();
  options.samples = 1;
  const Frame display = SceneRenderer("gallery", options).Render(1);
  options.linear = true;
  const Frame linear = SceneRenderer("gallery", options).Render(1);
  options.exposure = 16;
  const Frame exposed = SceneRenderer("gallery", options).Render(1);
  float brightest = 0;
  for (Image Frame::*image : {&Frame::color, &Frame::reference}) {
    for (int y = 0; y < (linear.*image).height; ++y) {
      for (int x = 0; x < (linear.*image).width; ++x) {
        for (int c = 0; c < 3; ++c) {
          const float light = (linear.*image).at(x, y, c);
          ASSERT_NEAR((display.*image).at(x, y, c), Displayed(light), 1e-6f);
          ASSERT_FLOAT_EQ((exposed.*image).at(x, y, c), 16 * light);
          brightest = std::max(brightest, (exposed.*image).at(x, y, c));
        }
      }
    }
  }
  EXPECT_GT(brightest, 4);
  EXPECT_EQ(linear.motion.data, display.motion.data);
}

TEST(Scenes, AllRenderEveryStreamInRange) {
  RenderOptions options = Small();
  options.samples = 1;
  for (const SceneInfo& scene : Scenes()) {
    SCOPED_TRACE(scene.name);
    const SceneRenderer renderer(std::string(scene.name), options);
    const Frame frame = renderer.Render(1);
    EXPECT_EQ(frame.number, 1);
    EXPECT_TRUE(frame.camera.has_value());
    EXPECT_EQ(frame.reference.width, 64);
    EXPECT_EQ(frame.reference_motion.channels, 2);
    EXPECT_EQ(frame.color.width, 32);
    EXPECT_EQ(frame.depth.height, 18);
    for (const Image* image : {&frame.reference, &frame.color}) {
      for (const float v : image->data) ASSERT_TRUE(v >= 0 && v <= 1) << v;
      const auto [low, high] = std::minmax_element(image->data.begin(), image->data.end());
      EXPECT_GT(*high - *low, 0.3f);
    }
    for (const Image* image : {&frame.reference_depth, &frame.depth}) {
      for (const float v : image->data) ASSERT_TRUE(v > 0 && v <= 1) << v;
    }
    for (const Image* image : {&frame.reference_motion, &frame.motion}) {
      for (const float v : image->data) ASSERT_TRUE(std::isfinite(v));
    }
  }
}

TEST(Scenes, SeedChangesThePicture) {
  RenderOptions options = Small();
  const Frame one = SceneRenderer("courtyard", options).Render(0);
  options.seed = 2;
  const Frame two = SceneRenderer("courtyard", options).Render(0);
  EXPECT_NE(one.reference.data, two.reference.data);
}

TEST(SceneRenderer, ThreadsDoNotChangeTheBits) {
  for (const char* scene : {"gallery", "plaza"}) {
    RenderOptions options = Small();
    options.threads = 1;
    const Frame one = SceneRenderer(scene, options).Render(3);
    options.threads = 3;
    const Frame three = SceneRenderer(scene, options).Render(3);
    EXPECT_EQ(one.reference.data, three.reference.data);
    EXPECT_EQ(one.reference_depth.data, three.reference_depth.data);
    EXPECT_EQ(one.reference_motion.data, three.reference_motion.data);
    EXPECT_EQ(one.color.data, three.color.data);
    EXPECT_EQ(one.depth.data, three.depth.data);
    EXPECT_EQ(one.motion.data, three.motion.data);
  }
}

// Samples at the positions of the render grid are its pixels, whichever of them are asked for, in
// whatever order.
TEST(SceneRenderer, TracesTheSamplesThatAreAskedFor) {
  RenderOptions options = Small();
  options.scale = 1;
  options.reference = false;
  const SceneRenderer renderer("gallery", options);
  const Frame frame = renderer.Render(2);
  std::vector<Vec2> positions;
  for (int y = 1; y < options.height; y += 7) {
    for (int x = 2; x < options.width; x += 5) {
      positions.push_back({x + 0.5 + frame.jitter.x, y + 0.5 + frame.jitter.y});
    }
  }
  const std::vector<SceneSample> samples = renderer.Trace(2, positions);
  ASSERT_EQ(samples.size(), positions.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int x = static_cast<int>(positions[i].x), y = static_cast<int>(positions[i].y);
    for (int c = 0; c < 3; ++c) ASSERT_FLOAT_EQ(samples[i].color[c], frame.color.at(x, y, c));
    ASSERT_EQ(samples[i].depth, frame.depth.at(x, y));
    for (int c = 0; c < 2; ++c) ASSERT_FLOAT_EQ(samples[i].motion[c], frame.motion.at(x, y, c));
  }
  EXPECT_THROW(renderer.Trace(options.frames, positions), Error);
}

// The point that a reflected ray meets is what the camera sees where the ray is said to end.
TEST(SceneRenderer, ReflectionsEndWhereTheCameraSeesThem) {
  const RenderOptions options = Small();
  const SceneRenderer renderer("colonnade", options);
  std::vector<Vec2> positions;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; x += 2) positions.push_back({x + 0.5, y + 0.5});
  }
  const std::vector<SceneReflection> reflections = renderer.Reflect(1, positions);
  std::vector<Vec2> ends;
  for (const SceneReflection& reflection : reflections) ends.push_back(reflection.position);
  const std::vector<SceneSample> seen = renderer.Trace(1, ends);
  const std::vector<SceneSample> surfaces = renderer.Trace(1, positions);
  const Camera camera = renderer.CameraAt(1);
  const double fx = camera.projection[0] * options.width / 2;
  const double fy = camera.projection[5] * options.height / 2;
  int visible = 0;
  for (std::size_t i = 0; i < reflections.size(); ++i) {
    const SceneReflection& r = reflections[i];
    const auto [x, y, z] = r.origin;
    const auto [dx, dy, dz] = r.direction;
    EXPECT_EQ(r.is_surface, surfaces[i].depth < 1);
    if (!r.is_surface) continue;
    EXPECT_NEAR(dx * dx + dy * dy + dz * dz, 1, 1e-5);
    // A pixel over the surface: seen from the centre of the image a pixel away at most, from where
    // the view is slanted that much more; 5 % for what it is nearer.
    const double right = (positions[i].x - options.width * 0.5) / fx;
    const double down = (positions[i].y - options.height * 0.5) / fy;
    EXPECT_LE(std::hypot(fx * (x / z - right), fy * (y / z - down)),
              1.05 * std::hypot(1, right, down));
    if (!r.is_visible) continue;
    ++visible;
    EXPECT_TRUE(r.is_hit);
    // The point that is seen lies on the ray.
    const double depth = seen[i].depth * renderer.far_plane();
    const double px = (r.position.x - options.width * 0.5) / fx * depth - x;
    const double py = (r.position.y - options.height * 0.5) / fy * depth - y, pz = depth - z;
    const double along = px * dx + py * dy + pz * dz;
    EXPECT_GT(along, 0);
    EXPECT_LE(std::hypot(px - along * dx, py - along * dy, pz - along * dz), 0.01 * depth);
  }
  EXPECT_GT(visible, 20);
  EXPECT_THROW(renderer.Reflect(options.frames, positions), Error);
}

// Frame 8 at 240 frames per second is frame 1 at 30, with about an eighth of its motion.
TEST(SceneRenderer, RatesShareTheirMoments) {
  RenderOptions options = Small();
  options.scale = 1;
  const Frame slow = SceneRenderer("street", options).Render(1);
  options.rate = 240;
  const Frame fast = SceneRenderer("street", options).Render(8);
  EXPECT_EQ(fast.reference.data, slow.reference.data);
  EXPECT_EQ(fast.reference_depth.data, slow.reference_depth.data);
  double slow_length = 0, fast_length = 0;
  for (std::size_t i = 0; i < slow.reference_motion.data.size(); ++i) {
    slow_length += std::abs(slow.reference_motion.data[i]);
    fast_length += std::abs(fast.reference_motion.data[i]);
  }
  EXPECT_GT(slow_length, 0);
  EXPECT_NEAR(8 * fast_length / slow_length, 1, 0.05);
}

// The light of penumbra moves over a wall that rests; from frame to frame it changes a little.
TEST(Scenes, PenumbraMovesItsShadowsAlone) {
  const RenderOptions options = Small();
  const SceneRenderer renderer("penumbra", options);
  const Frame one = renderer.Render(4), two = renderer.Render(5);
  for (const float v : two.reference_motion.data) ASSERT_EQ(v, 0);
  EXPECT_EQ(one.reference_depth.data, two.reference_depth.data);
  double change = 0;
  float most = 0;
  for (std::size_t i = 0; i < one.reference.data.size(); ++i) {
    const float difference = std::abs(two.reference.data[i] - one.reference.data[i]);
    change += static_cast<double>(difference) / static_cast<double>(one.reference.data.size());
    most = std::max(most, difference);
  }
  EXPECT_GT(change, 0.002);
  EXPECT_GT(most, 0.02f);
  EXPECT_LT(most, 0.15f) << "soft edges";
}

// Rims move by less than a pixel of the output from frame to frame, before a wall that rests.
TEST(Scenes, RimsSwaySlowly) {
  RenderOptions options = Small();
  options.width = 240;
  options.height = 135;
  const Frame frame = SceneRenderer("rims", options).Render(5);
  int moving = 0;
  float bright = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const float length =
          std::hypot(frame.reference_motion.at(x, y, 0), frame.reference_motion.at(x, y, 1));
      moving += length > 0;
      ASSERT_LT(length, 1);
      bright = std::max(bright, frame.reference.at(x, y, 1));
    }
  }
  const auto pixels = static_cast<double>(frame.reference.pixels());
  EXPECT_GT(moving, 0.1 * pixels);
  EXPECT_LT(moving, 0.7 * pixels);
  EXPECT_GT(bright, 0.5f);
}

TEST(SceneRenderer, UnknownSceneNamesThoseThatExist) {
  const std::string error = ErrorOf("nowhere", Small());
  EXPECT_NE(error.find("nowhere"), std::string::npos);
  for (const SceneInfo& scene : Scenes())
    EXPECT_NE(error.find(scene.name), std::string::npos) << scene.name;
}

TEST(SceneRenderer, InvalidOptionsAreRefused) {
  RenderOptions options = Small();
  options.width = 3;
  EXPECT_NE(ErrorOf("still", options).find("width is 3"), std::string::npos);
}

TEST(SceneRenderer, FrameIndexOutOfRangeIsRefused) {
  EXPECT_NE(ErrorOf("still", Small(), 12).find("12"), std::string::npos);
  EXPECT_NE(ErrorOf("still", Small(), -1).find("-1"), std::string::npos);
}

TEST(SceneRenderer, StreamsThatAreNotWantedAreEmpty) {
  RenderOptions options = Small();
  options.reference = false;
  const Frame inputs = SceneRenderer("still", options).Render(0);
  EXPECT_TRUE(inputs.reference.empty() && inputs.reference_depth.empty() &&
              inputs.reference_motion.empty());
  EXPECT_FALSE(inputs.color.empty());
  options.reference = true;
  options.inputs = false;
  const Frame reference = SceneRenderer("still", options).Render(0);
  EXPECT_TRUE(reference.color.empty() && reference.depth.empty() && reference.motion.empty());
  EXPECT_FALSE(reference.reference.empty());
}

TEST(SceneRenderer, RenderGridIsRounded) {
  RenderOptions options = Small();
  options.scale = 1.7;
  const SceneRenderer renderer("still", options);
  EXPECT_EQ(renderer.render_width(), 38);
  EXPECT_EQ(renderer.render_height(), 21);
}

TEST(SceneRenderer, JitterCycleGrowsWithTheScale) {
  const std::pair<double, std::size_t> cases[] = {{1, 8}, {1.5, 18}, {1.7, 23}, {2, 32}, {3, 72}};
  for (const auto& [scale, count] : cases) {
    RenderOptions options = Small();
    options.scale = scale;
    const auto jitter = SceneRenderer("still", options).Jitter();
    EXPECT_EQ(jitter.size(), count);
    std::set<std::pair<double, double>> distinct;
    for (const Vec2& j : jitter) {
      EXPECT_LE(std::abs(j.x), 0.5);
      EXPECT_LE(std::abs(j.y), 0.5);
      distinct.insert({j.x, j.y});
    }
    EXPECT_EQ(distinct.size(), count);
  }
}

TEST(SceneRenderer, CutsAreFlaggedAndHaveNoMotion) {
  const SceneRenderer harbour("harbour", Small());
  EXPECT_EQ(harbour.Cuts(), (std::vector<int>{4, 8}));
  const Frame cut = harbour.Render(4), after = harbour.Render(5);
  EXPECT_TRUE(cut.cut);
  EXPECT_FALSE(after.cut);
  EXPECT_TRUE(std::all_of(cut.reference_motion.data.begin(), cut.reference_motion.data.end(),
                          [](float v) { return v == 0; }));
  EXPECT_FALSE(std::all_of(after.motion.data.begin(), after.motion.data.end(),
                           [](float v) { return v == 0; }));
  EXPECT_TRUE(SceneRenderer("street", Small()).Cuts().empty());
}

TEST(RenderOptions, EachFieldIsChecked) {
  EXPECT_TRUE(RenderOptions{}.IsValid(nullptr));
  const auto with = [](auto change) {
    RenderOptions options;
    change(options);
    return WhyInvalid(options);
  };
  EXPECT_NE(with([](auto& o) { o.width = 7; }).find("width"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.height = 20000; }).find("height"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.scale = 0.5; }).find("scale"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.scale = std::nan(""); }).find("scale"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.frames = 0; }).find("frames"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.rate = 0.5; }).find("rate"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.samples = 0; }).find("samples"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.threads = -1; }).find("threads"), std::string::npos);
  EXPECT_NE(with([](auto& o) { o.reference = o.inputs = false; }).find("reference"),
            std::string::npos);
}

}  // namespace
}  // namespace warplut
