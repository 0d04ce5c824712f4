#include "luts/table.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/runtime/test_table.h"

namespace warplut {
namespace {

class TableTest : public testing::TestWithParam<TableFormat> {
 protected:
  TestTable stored = MakeKeysTable(GetParam());
  Table table{stored.view()};
};

TEST_P(TableTest, NodesHoldTheStoredWeights) {
  const double unit = std::ldexp(1.0, -FractionBits(GetParam()));
  for (int jy = 0; jy < kNodes; ++jy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      const float dx = static_cast<float>(NodeOffset(ix));
      const float dy = static_cast<float>(NodeOffset(jy));
      const auto expected = KeysWeights(-0.58, double{dx}, double{dy});
      for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
        const Weights<float> w = table.At(dx, dy, lookup);
        for (int k = 0; k < kWeights; ++k) ASSERT_NEAR(w[k], expected[k], 8.5 * unit);
      }
      EXPECT_EQ(table.At(dx, dy, Lookup::kNearest), table.At(dx, dy, Lookup::kBilinear));
    }
  }
}

TEST_P(TableTest, WeightsSumToOne) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> offset(0, std::nextafter(1.0f, 0.0f));
  for (int i = 0; i < 10000; ++i) {
    const float dx = offset(random);
    const float dy = offset(random);
    double nearest = 0;
    double bilinear = 0;
    for (const float w : table.At(dx, dy, Lookup::kNearest)) nearest += w;
    for (const float w : table.At(dx, dy, Lookup::kBilinear)) bilinear += w;
    ASSERT_EQ(nearest, 1.0);
    ASSERT_NEAR(bilinear, 1.0, 0x1p-21);
  }
}

TEST_P(TableTest, ZeroOffsetIsTheIdentity) {
  for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
    const Weights<float> w = table.At(0, 0, lookup);
    for (int k = 0; k < kWeights; ++k) EXPECT_EQ(w[k], k == kIdentityWeight ? 1.0f : 0.0f);
  }
}

TEST_P(TableTest, NodeThirtyTwoIsNodeZeroOfTheNextTexel) {
  const float last = std::nextafter(1.0f, 0.0f);
  const Weights<float> right = table.At(last, 0, Lookup::kNearest);
  const Weights<float> both = table.At(last, last, Lookup::kNearest);
  for (int k = 0; k < kWeights; ++k) {
    EXPECT_EQ(right[k], TapX(k) == 1 && TapY(k) == 0 ? 1.0f : 0.0f);
    EXPECT_EQ(both[k], TapX(k) == 1 && TapY(k) == 1 ? 1.0f : 0.0f);
  }
}

TEST_P(TableTest, OfMoreTapsHoldsTheStoredWeights) {
  const double unit = std::ldexp(1.0, -FractionBits(GetParam()));
  for (const Footprint footprint : {Footprint::k24, Footprint::k36}) {
    const Table wide(MakeWideTable(GetParam(), footprint).view());
    EXPECT_EQ(wide.footprint(), footprint);
    for (int jy = 0; jy <= kNodes; ++jy) {
      for (int ix = 0; ix <= kNodes; ++ix) {
        const double dx = std::min(NodeOffset(ix), 1 - 1e-7),
                     dy = std::min(NodeOffset(jy), 1 - 1e-7);
        const auto expected = WideWeights(footprint, 4.5, NodeOffset(ix), NodeOffset(jy));
        const Weights<float> w =
            wide.At(static_cast<float>(dx), static_cast<float>(dy), Lookup::kNearest);
        for (int k = 0; k < kWeights; ++k) {
          ASSERT_NEAR(w[k], expected[k], 0.5 * TapCount(footprint) * unit);
          if (!HasTap(footprint, TapX(k), TapY(k))) {
            ASSERT_EQ(w[k], 0);
          }
        }
      }
    }
  }
}

TEST(TapLayout, HasEveryTapOnceInRunsOrPairs) {
  for (const Footprint footprint : kFootprints) {
    const TapLayout& layout = LayoutOf(footprint);
    Weights<int> seen{};
    for (int place = 0; place < TapCount(footprint); ++place) ++seen[layout.Weight(place)];
    for (int k = 0; k < kWeights; ++k) {
      EXPECT_EQ(seen[k], HasTap(footprint, TapX(k), TapY(k)) ? 1 : 0);
    }
    for (int i = 0; i < layout.count && footprint == Footprint::k16; ++i) {
      EXPECT_TRUE(layout.groups[i].is_run);
    }
  }
}

TEST_P(TableTest, CopiesOwnTheirRows) {
  const Weights<float> expected = table.At(0.3f, 0.7f, Lookup::kBilinear);
  Table copy = Table(stored.view());
  {
    const Table other = table;
    copy = other;
  }
  EXPECT_EQ(copy.At(0.3f, 0.7f, Lookup::kBilinear), expected);
  EXPECT_NE(copy.data(), table.data());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % 64, 0u);
}

INSTANTIATE_TEST_SUITE_P(Formats, TableTest, testing::ValuesIn(kTableFormats),
                         [](const auto& test) { return std::string(Name(test.param)); });

}  // namespace
}  // namespace warplut
