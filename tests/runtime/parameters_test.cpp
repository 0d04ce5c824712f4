#include "runtime/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace warplut {
namespace {

TEST(Parameters, DefaultsAndThePapersAreValid) {
  std::string why;
  EXPECT_TRUE(Parameters{}.IsValid(&why)) << why;
  EXPECT_TRUE(kPaperParameters.IsValid(&why)) << why;
}

TEST(Parameters, TakesTheEndsOfEveryRange) {
  for (const ParameterInfo& info : kParameters) {
    for (const float end : {info.min, info.max}) {
      Parameters parameters;
      parameters.*info.member = end;
      EXPECT_TRUE(parameters.IsValid()) << info.name;
    }
  }
}

TEST(Parameters, NamesWhatIsOutOfRange) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const ParameterInfo& info : kParameters) {
    for (const float value :
         {std::nextafter(info.min, -kInfinity), std::nextafter(info.max, kInfinity), kInfinity,
          -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
      Parameters parameters;
      parameters.*info.member = value;
      std::string why;
      EXPECT_FALSE(parameters.IsValid(&why)) << info.name << " " << value;
      EXPECT_EQ(why.rfind(info.name, 0), 0u) << why;
      EXPECT_FALSE(parameters.IsValid());
    }
  }
}

TEST(Parameters, TheTableNamesEachOnce) {
  static_assert(kParameters.size() * sizeof(float) == sizeof(Parameters));
  std::set<std::string> names;
  Parameters filled;
  float next = 1000;
  for (const ParameterInfo& info : kParameters) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_LT(info.min, info.max) << info.name;
    EXPECT_TRUE(!info.logarithmic || info.min > 0) << info.name;
    EXPECT_NE(info.meaning[0], '\0') << info.name;
    filled.*info.member = next++;
  }
  // Every member was set, none twice.
  float expected = 1000;
  for (const ParameterInfo& info : kParameters) EXPECT_EQ(filled.*info.member, expected++);
}

}  // namespace
}  // namespace warplut
