// The share of coherent residuals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "runtime/sr/reference.h"
#include "tests/runtime/sr/sr_fixture.h"

namespace warplut {
namespace {

TEST(CoherentShare, IsTheWholeOfWhatAgreesAndLittleOfWhatDoesNot) {
  EXPECT_FLOAT_EQ(CoherentPart(0.04f, 0), 1);
  EXPECT_FLOAT_EQ(CoherentPart(0.04f, 0.04f), 0.2f);
  EXPECT_FLOAT_EQ(CoherentPart(0, 0.1f), 0);
  EXPECT_EQ(CoherentPart(0, 0), 0);
  float sum = 0;
  for (int k = -kCoherentReach; k <= kCoherentReach; ++k) sum += CoherentTap(k);
  EXPECT_FLOAT_EQ(sum, 1);
  EXPECT_EQ(CoherentTap(kCoherentReach + 1), 0);
}

TEST(CoherentShare, IsRefusedOutsideOfItsRange) {
  SuperResolutionOptions options = TestOptions(8, 8, 16, 16);
  for (const float share : {-0.1f, 1.1f, std::nanf("")}) {
    options.coherent_share = share;
    std::string why;
    EXPECT_FALSE(options.IsValid(&why));
    EXPECT_NE(why.find("coherent residuals"), std::string::npos) << why;
  }
}

}  // namespace
}  // namespace warplut
