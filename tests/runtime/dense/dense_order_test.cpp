#include "runtime/dense_order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace warplut {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr DenseParameters kPublished;

BlockOrder At(OrderRule rule, float fraction, float angle, std::uint32_t random = 0) {
  const float length = 2 + fraction;
  return ChooseOrder(rule, kPublished, length * std::cos(angle), length * std::sin(angle), random);
}

constexpr OrderRule kAdaptive[] = {OrderRule::kDominant, OrderRule::kRising, OrderRule::kFalling,
                                   OrderRule::kMixed};

TEST(DenseOrder, TakesEquation4AndEquation5OnTheAxes) {
  for (const OrderRule rule : kAdaptive) {
    for (const float sign : {-1.0f, 1.0f}) {
      for (float fraction = 0.03f; fraction < 1; fraction += 0.05f) {
        const bool inside = fraction > 0.25f && fraction < 0.75f;
        const float length = sign * (2 + fraction);
        EXPECT_EQ(ChooseOrder(rule, kPublished, length, 0, 0) == BlockOrder::kHourglass, inside)
            << Name(rule) << " " << length;
        EXPECT_EQ(ChooseOrder(rule, kPublished, 0, length, 0) == BlockOrder::kBowtie, inside)
            << Name(rule) << " " << length;
      }
    }
  }
}

TEST(DenseOrder, BoundsBelongToTheSetsOfTheEquations) {
  for (const float length : {0.25f, 0.75f, 3.25f}) {
    EXPECT_EQ(ChooseOrder(OrderRule::kMixed, kPublished, length, 0, 0), BlockOrder::kBowtie);
  }
  EXPECT_EQ(ChooseOrder(OrderRule::kMixed, kPublished, 0, 0, 0), BlockOrder::kBowtie);
}

// An exchange of x and y exchanges rows and columns, rising and falling.
TEST(DenseOrder, RulesAreSymmetricalAboutTheDiagonal) {
  for (float angle = 0.02f; angle < kPi / 2; angle += 0.11f) {
    for (float fraction = 0.02f; fraction < 1; fraction += 0.06f) {
      const float other = kPi / 2 - angle;
      EXPECT_NE(At(OrderRule::kRising, fraction, angle), At(OrderRule::kFalling, fraction, other));
      EXPECT_NE(At(OrderRule::kDominant, fraction, angle),
                At(OrderRule::kDominant, fraction, other));
      if (std::abs(angle - kPi / 4) < kPublished.random_angle) continue;
      EXPECT_NE(At(OrderRule::kMixed, fraction, angle), At(OrderRule::kMixed, fraction, other));
    }
  }
}

TEST(DenseOrder, MixedIsRandomAroundTheDiagonalAlone) {
  for (const float angle : {kPi / 4 - 0.07f, kPi / 4, kPi / 4 + 0.07f}) {
    EXPECT_EQ(At(OrderRule::kMixed, 0.4f, angle, 6), BlockOrder::kBowtie);
    EXPECT_EQ(At(OrderRule::kMixed, 0.4f, angle, 7), BlockOrder::kHourglass);
  }
  for (const float angle : {kPi / 4 - 0.09f, kPi / 4 + 0.09f}) {
    EXPECT_EQ(At(OrderRule::kMixed, 0.4f, angle, 6), At(OrderRule::kMixed, 0.4f, angle, 7));
  }
}

TEST(DenseOrder, OrdersVisitEachPixelOnce) {
  for (const BlockOrder order : {BlockOrder::kHourglass, BlockOrder::kBowtie}) {
    int places = 0;
    for (int i = 0; i < 4; ++i) {
      places |= 1 << PlaceInOrder(order, i);
      EXPECT_EQ(PlaceInOrder(order, PlaceInOrder(order, i)), i);
    }
    EXPECT_EQ(places, 15);
  }
  EXPECT_EQ(PlaceInOrder(BlockOrder::kHourglass, 1), 1);
  EXPECT_EQ(PlaceInOrder(BlockOrder::kBowtie, 1), 2);
}

TEST(DenseParameters, TheTableNamesEachOnceAndRangesAreChecked) {
  static_assert(kDenseParameters.size() * sizeof(float) == sizeof(DenseParameters));
  EXPECT_TRUE(kPublished.IsValid());
  for (const DenseParameterInfo& info : kDenseParameters) {
    for (const float value : {info.min - 0.1f, info.max + 0.1f, std::nanf("")}) {
      DenseParameters parameters;
      parameters.*info.member = value;
      std::string why;
      EXPECT_FALSE(parameters.IsValid(&why)) << info.name;
      EXPECT_EQ(why.rfind(info.name, 0), 0U) << why;
    }
    for (const float value : {info.min, info.max}) {
      DenseParameters parameters;
      parameters.*info.member = value;
      EXPECT_TRUE(parameters.IsValid()) << info.name;
    }
  }
}

}  // namespace
}  // namespace warplut
