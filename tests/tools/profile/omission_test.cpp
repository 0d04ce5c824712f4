#include "tools/profile/omission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "runtime/method.h"

namespace warplut {
namespace {

ProfiledPipeline Full(const char* method, bool one_grid = false) {
  ModeRunOptions options;
  options.method = FindMethod(method);
  options.super_resolution.warp.filter = options.generation.warp.filter = Filter::kLut;
  return FullPipeline(options, one_grid);
}

std::set<std::string> Applicable(const ProfiledPipeline& full) {
  std::set<std::string> names;
  for (const Omission& omission : Omissions()) {
    ProfiledPipeline pipeline = full;
    if (omission.leave_out(pipeline)) names.insert(omission.name);
  }
  return names;
}

// What the omission of that name says.
bool LeaveOut(const std::string& name, ProfiledPipeline& pipeline) {
  for (const Omission& omission : Omissions()) {
    if (name == omission.name) return omission.leave_out(pipeline);
  }
  throw std::invalid_argument(name);
}

bool Reads(const ProfiledPipeline& pipeline, float Parameters::*member) {
  for (const int index : pipeline.parameters) {
    if (kParameters[static_cast<std::size_t>(index)].member == member) return true;
  }
  return false;
}

TEST(Omission, EachHasItsOwnName) {
  std::set<std::string> names;
  for (const Omission& omission : Omissions()) {
    EXPECT_TRUE(names.insert(omission.name).second) << omission.name;
  }
}

TEST(Omission, NothingIsLeftOutTwice) {
  for (const char* method : {"sr", "i", "e", "isr", "esr"}) {
    for (const bool one_grid : {false, true}) {
      for (const Omission& omission : Omissions()) {
        ProfiledPipeline pipeline = Full(method, one_grid);
        if (!omission.leave_out(pipeline)) continue;
        EXPECT_FALSE(omission.leave_out(pipeline)) << method << " " << omission.name;
      }
    }
  }
}

TEST(Omission, EveryOneAppliesToSomeMode) {
  std::set<std::string> names;
  for (const char* method : {"sr", "i", "e"}) names.merge(Applicable(Full(method, true)));
  // What ships has no bicubic current frame.
  names.insert("bicubic-frame");
  EXPECT_EQ(names.size(), Omissions().size());
}

TEST(Omission, DependsOnTheMode) {
  using testing::Contains;
  using testing::Not;
  EXPECT_THAT(Applicable(Full("sr")), Not(Contains("super-resolution")));
  EXPECT_THAT(Applicable(Full("sr", true)), Contains("super-resolution"));
  EXPECT_THAT(Applicable(Full("sr")), Not(Contains("brightness-gate")));
  EXPECT_THAT(Applicable(Full("i")), Contains("brightness-gate"));
  EXPECT_THAT(Applicable(Full("i")), Not(Contains("disocclusion-filling")));
  EXPECT_THAT(Applicable(Full("e")), Contains("disocclusion-filling"));
  EXPECT_THAT(Applicable(Full("e")), Not(Contains("moved-generation")));
  EXPECT_THAT(Applicable(Full("i")), Not(Contains("history")));
}

TEST(Omission, TheFullPipelineHasEveryPass) {
  const ProfiledPipeline sr = Full("sr"), i = Full("i"), isr = Full("isr");
  EXPECT_TRUE(sr.sr.motion_filter);
  EXPECT_TRUE(i.generation.brightness_gate);
  EXPECT_TRUE(i.generation.motion_filter);
  EXPECT_TRUE(isr.sr.motion_filter);
  EXPECT_FALSE(isr.generation.motion_filter) << "its motion comes filtered";
  EXPECT_TRUE(Reads(i, &Parameters::brightness_threshold));
}

TEST(Omission, DropsParametersOfWhatIsLeftOut) {
  const auto reads_without = [](const char* method, const char* name, float Parameters::*member) {
    ProfiledPipeline pipeline = Full(method);
    EXPECT_TRUE(Reads(pipeline, member));
    EXPECT_TRUE(LeaveOut(name, pipeline));
    return Reads(pipeline, member);
  };
  EXPECT_FALSE(reads_without("sr", "history-depth-gate", &Parameters::sr_depth_threshold));
  EXPECT_FALSE(reads_without("sr", "history-motion", &Parameters::sr_depth_threshold));
  EXPECT_FALSE(reads_without("sr", "variance-box", &Parameters::clamp_gamma));
  EXPECT_FALSE(reads_without("sr", "color-box", &Parameters::clamp_gamma));
  EXPECT_FALSE(reads_without("sr", "history", &Parameters::blend_a));
  EXPECT_TRUE(reads_without("sr", "color-box", &Parameters::blend_b));
  EXPECT_FALSE(reads_without("i", "brightness-gate", &Parameters::brightness_threshold));
  EXPECT_FALSE(
      reads_without("isr", "generation-depth-gate", &Parameters::generation_depth_threshold));
  EXPECT_TRUE(reads_without("isr", "generation", &Parameters::sr_depth_threshold));
}

TEST(Omission, CheaperFiltersFollowEachOther) {
  ProfiledPipeline pipeline = Full("isr");
  for (const char* name : {"table-interpolation", "table", "table-and-cubic"}) {
    EXPECT_TRUE(LeaveOut(name, pipeline)) << name;
    EXPECT_EQ(pipeline.sr.warp.filter, pipeline.generation.warp.filter);
  }
  EXPECT_FALSE(LeaveOut("table", pipeline)) << "Catmull-Rom is dearer";
  EXPECT_FALSE(pipeline.ReadsTable());
}

TEST(Configuration, HoldsWhatIsLeft) {
  ProfiledPipeline pipeline = Full("isr");
  PipelineConfiguration configuration = ConfigurationOf(pipeline, ColorEncoding::kDisplay);
  EXPECT_TRUE(configuration.super_resolution);
  EXPECT_TRUE(configuration.interpolation);
  EXPECT_FALSE(configuration.extrapolation);
  EXPECT_FALSE(configuration.reference);
  EXPECT_EQ(configuration.filter, Filter::kLut);
  EXPECT_EQ(configuration.lookup, Lookup::kBilinear);
  EXPECT_EQ(configuration.sr.clamp, ColorClamp::kVariance);
  EXPECT_EQ(configuration.generation.brightness_gate, true);
  EXPECT_FALSE(configuration.generation.fill) << "interpolation has one way";

  ASSERT_TRUE(LeaveOut("generation", pipeline));
  ASSERT_TRUE(LeaveOut("history-motion", pipeline));
  configuration = ConfigurationOf(pipeline, ColorEncoding::kDisplay);
  EXPECT_FALSE(configuration.interpolation);
  EXPECT_FALSE(configuration.filter) << "nothing is warped";
  EXPECT_FALSE(configuration.sr.depth) << "no depth is read";
  EXPECT_EQ(configuration.sr.motion, MotionUpsampling::kStatic);
  EXPECT_FALSE(configuration.generation.motion_model);

  ProfiledPipeline bare = Full("sr", true);
  ASSERT_TRUE(LeaveOut("super-resolution", bare));
  configuration = ConfigurationOf(bare, ColorEncoding::kDisplay);
  EXPECT_FALSE(configuration.super_resolution);
  EXPECT_FALSE(configuration.sr.history);
}

}  // namespace
}  // namespace warplut
