#include "runtime/method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "runtime/configuration/choice_list.h"

namespace warplut {
namespace {

SuperResolutionOptions Sized() {
  SuperResolutionOptions options;
  options.render_width = 20;
  options.render_height = 10;
  options.output_width = 40;
  options.output_height = 15;
  return options;
}

bool Reads(const MethodInfo& method, float Parameters::*member) {
  return std::any_of(method.parameters.begin(), method.parameters.end(), [&](int i) {
    return kParameters[static_cast<std::size_t>(i)].member == member;
  });
}

TEST(Method, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const MethodInfo& method : Methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_EQ(FindMethod(method.name), &method);
    EXPECT_FALSE(std::string(method.meaning).empty()) << method.name;
  }
  EXPECT_EQ(FindMethod(""), nullptr);
  EXPECT_EQ(FindMethod("SR"), nullptr);
}

TEST(Method, EachModeHasThePapersForm) {
  for (const std::string mode : {"sr", "i", "e", "isr", "esr"}) {
    const MethodInfo* ours = FindMethod(mode);
    const MethodInfo* paper = FindMethod(mode + "-paper");
    ASSERT_NE(ours, nullptr) << mode;
    ASSERT_NE(paper, nullptr) << mode;
    EXPECT_FALSE(ours->paper);
    EXPECT_TRUE(paper->paper);
    EXPECT_EQ(ours->super_resolution, paper->super_resolution);
    EXPECT_EQ(ours->generation, paper->generation);
  }
}

TEST(Method, ConfiguresWhereItAppliesAndNowhereElse) {
  for (const MethodInfo& method : Methods()) {
    EXPECT_EQ(method.configure_super_resolution != nullptr, method.super_resolution) << method.name;
    const bool warped =
        method.generation != Generation::kNone && method.generator == Generator::kWarped;
    EXPECT_EQ(method.configure_generation != nullptr, warped) << method.name;
    EXPECT_TRUE(method.super_resolution || method.generation != Generation::kNone) << method.name;
  }
}

TEST(Method, ConfiguresValidOptionsAndLeavesTheRestAlone) {
  for (const MethodInfo& method : Methods()) {
    std::string why;
    if (method.super_resolution) {
      SuperResolutionOptions options = Sized();
      options.warp.filter = Filter::kBilinear;
      options.history_format = PixelFormat::kRgba32F;
      options.parameters.blend_a = 0.5f;
      options.gate_width = 0.25f;
      method.configure_super_resolution(options);
      EXPECT_TRUE(options.IsValid(&why)) << method.name << ": " << why;
      EXPECT_EQ(options.warp.filter, Filter::kBilinear);
      EXPECT_EQ(options.history_format, PixelFormat::kRgba32F);
      EXPECT_EQ(options.parameters.blend_a, 0.5f);
      EXPECT_EQ(options.gate_width, 0.25f);
      EXPECT_EQ(options.output_height, 15);
    }
    if (method.configure_generation != nullptr) {
      FrameGenerationOptions options;
      options.width = 40;
      options.height = 15;
      options.warp.filter = Filter::kBilinear;
      options.parameters.brightness_threshold = 0.5f;
      method.configure_generation(options);
      EXPECT_TRUE(options.IsValid(&why)) << method.name << ": " << why;
      EXPECT_EQ(options.warp.filter, Filter::kBilinear);
      EXPECT_EQ(options.parameters.brightness_threshold, 0.5f);
      EXPECT_EQ(options.width, 40);
    }
  }
}

// Whatever the options were, the method alone decides what is its own, and nothing else.
template <class List, class Options>
void ExpectOwnChoicesAlone(const List& list, void (*configure)(Options&), Options other) {
  const Options before = other;
  Options fresh;
  configure(fresh);
  configure(other);
  ForEachChoice(list, [&](const auto& choice) {
    if (choice.owner == ChoiceOwner::kFrames) return;
    const auto& expected = choice.owner == ChoiceOwner::kMethod ? fresh : before;
    EXPECT_EQ(other.*choice.option, expected.*choice.option) << choice.member;
  });
}

TEST(Method, ForgetsTheChoicesOfAnother) {
  SuperResolutionOptions sr;
  FindMethod("sr-paper")->configure_super_resolution(sr);
  FindMethod("bicubic")->configure_super_resolution(sr);
  sr.form = HistoryForm::kResidual;
  sr.clamp = ColorClamp::kNone;
  sr.depth = DepthMeasure::kNone;
  sr.motion = MotionUpsampling::kNearest;
  sr.history_format = PixelFormat::kRgba32F;
  sr.encoding = ColorEncoding::kLinearHdr;
  FrameGenerationOptions generation;
  generation.motion_model = MotionModel::kLinear;
  generation.splat = false;
  generation.refine = false;
  generation.fill = DisocclusionFill::kNone;
  generation.depth = DepthMeasure::kNone;
  generation.brightness_gate = true;
  generation.encoding = ColorEncoding::kLinearHdr;
  for (const MethodInfo& method : Methods()) {
    SCOPED_TRACE(method.name);
    if (method.super_resolution) {
      ExpectOwnChoicesAlone(kSrChoices, method.configure_super_resolution, sr);
    }
    if (method.configure_generation != nullptr) {
      ExpectOwnChoicesAlone(kGenerationChoices, method.configure_generation, generation);
    }
  }
}

TEST(Method, OnlyPeersNameAPeer) {
  for (const char* peer : {"taau", "sgsr2", "fsr2", "3dwarp", "3dwarp-e", "bidir", "mesh"}) {
    EXPECT_TRUE(FindMethod(peer)->peer) << peer;
  }
  for (const char* own : {"sr", "i", "e", "isr-paper", "bicubic", "flow", "average"}) {
    EXPECT_FALSE(FindMethod(own)->peer) << own;
  }
  for (const MethodInfo& method : Methods()) {
    if (method.configure_generation != nullptr) {
      FrameGenerationOptions options;
      options.peer = &kMeshWarp;
      method.configure_generation(options);
      EXPECT_EQ(options.peer != nullptr, method.peer) << method.name;
    }
    if (!method.super_resolution) continue;
    SuperResolutionOptions options = Sized();
    FindMethod("taau")->configure_super_resolution(options);
    EXPECT_EQ(options.peer, &kTaau);
    method.configure_super_resolution(options);
    EXPECT_EQ(options.peer != nullptr, method.peer) << method.name;
  }
}

TEST(Method, NamesTheParametersThatItsPassesRead) {
  for (const MethodInfo& method : Methods()) {
    std::set<int> indices(method.parameters.begin(), method.parameters.end());
    EXPECT_EQ(indices.size(), method.parameters.size()) << method.name;
    SuperResolutionOptions sr = Sized();
    sr.history = false;
    if (method.super_resolution) method.configure_super_resolution(sr);
    const bool own = sr.history && sr.peer == nullptr;
    EXPECT_EQ(Reads(method, &Parameters::blend_a), own) << method.name;
    EXPECT_EQ(Reads(method, &Parameters::blend_b), own) << method.name;
    EXPECT_EQ(Reads(method, &Parameters::taau_blend), sr.peer == &kTaau) << method.name;
    EXPECT_EQ(Reads(method, &Parameters::taau_gamma), sr.peer == &kTaau) << method.name;
    EXPECT_EQ(Reads(method, &Parameters::sr_depth_threshold),
              sr.history && sr.depth != DepthMeasure::kNone)
        << method.name;
    EXPECT_EQ(Reads(method, &Parameters::clamp_gamma), own && sr.clamp == ColorClamp::kVariance)
        << method.name;
    FrameGenerationOptions generation;
    generation.depth = DepthMeasure::kNone;
    generation.brightness_gate = false;
    if (method.configure_generation != nullptr) method.configure_generation(generation);
    EXPECT_EQ(Reads(method, &Parameters::generation_depth_threshold),
              generation.depth != DepthMeasure::kNone)
        << method.name;
    EXPECT_EQ(Reads(method, &Parameters::brightness_threshold),
              generation.brightness_gate && method.generation == Generation::kInterpolation)
        << method.name;
  }
}

}  // namespace
}  // namespace warplut
