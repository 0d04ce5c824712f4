#include <gtest/gtest.h>

#include <cmath>

#include "luts/filters.h"
#include "luts/quantize/quantize.h"
#include "tools/profile/smaller_table.h"
#include "tools/table_format.h"

namespace warplut {
namespace {

RealTable Cubic() {
  return SampleWeights("cubic", kNodes, [](double dx, double dy) {
    return KeysWeights<double>(kCatmullRomA, dx, dy);
  });
}

TEST(SmallerTable, CountsWhatMustBeStored) {
  EXPECT_EQ(TableBytes(32, TableFormat::kI16), 32U * 32 * 16 * 2);
  EXPECT_EQ(TableBytes(8, TableFormat::kI8), 8U * 8 * 16);
  // Nodes 0 <= j <= i <= 16.
  EXPECT_EQ(EighthBytes(32, TableFormat::kI16), 17U * 18 / 2 * 16 * 2);
  EXPECT_EQ(EighthBytes(8, TableFormat::kF32), 5U * 6 / 2 * 16 * 4);
}

TEST(SmallerTable, KeepsAllNodesOfAStoredTable) {
  const BakedTable stored = Quantize(Cubic(), TableFormat::kI16);
  const RealTable real = ToRealTable(stored.view());
  EXPECT_EQ(Asymmetry(real), 0);
  const BakedTable again = RunnableTable(real, kNodes, TableFormat::kI16, Lookup::kBilinear);
  EXPECT_EQ(TableIntegers(again.view(), "again"), TableIntegers(stored.view(), "stored"));
}

// The bilinear lookup in a table of n nodes, beside the one in what the runtime is given for it.
TEST(SmallerTable, RunsFewerNodesExactly) {
  for (const int nodes : {16, 8}) {
    const BakedTable baked = RunnableTable(Cubic(), nodes, TableFormat::kI16, Lookup::kBilinear);
    const Table runnable(baked.view());
    RealTable coarse = SampleWeights("coarse", nodes, [](double dx, double dy) {
      return KeysWeights<double>(kCatmullRomA, dx, dy);
    });
    const std::vector<IntegerRow> rows = RoundTable(coarse, TableFormat::kI16);
    for (const float dx : {0.0f, 0.1f, 0.33f, 0.5f, 0.97f}) {
      for (const float dy : {0.02f, 0.625f, 0.9f}) {
        const double x = dx * nodes, y = dy * nodes;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const Weights<float> found = runnable.At(dx, dy, Lookup::kBilinear);
        double sum = 0;
        for (std::size_t k = 0; k < found.size(); ++k) {
          const auto at = [&](int a, int b) {
            const auto row = static_cast<std::size_t>(coarse.RowAt(a, b));
            return rows[row][k] / std::ldexp(1.0, FractionBits(TableFormat::kI16));
          };
          const double fx = x - i, fy = y - j;
          const double expected = (1 - fy) * ((1 - fx) * at(i, j) + fx * at(i + 1, j)) +
                                  fy * ((1 - fx) * at(i, j + 1) + fx * at(i + 1, j + 1));
          EXPECT_NEAR(found[k], expected, 1e-6) << nodes << " " << dx << " " << dy << " " << k;
          sum += found[k];
        }
        EXPECT_NEAR(sum, 1, 1e-6);
      }
    }
  }
}

TEST(SmallerTable, RunsEveryStorageAndLookup) {
  for (const int nodes : kSmallerNodes) {
    for (const TableFormat format : kTableFormats) {
      for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
        const BakedTable baked = RunnableTable(Cubic(), nodes, format, lookup);
        for (const IntegerRow& row : TableIntegers(baked.view(), "runnable")) {
          std::int64_t sum = 0;
          for (const std::int32_t q : row) sum += q;
          EXPECT_EQ(sum, std::int64_t{1} << FractionBits(baked.format()));
        }
      }
    }
  }
}

TEST(SmallerTable, TakesTheFewestBytesWithinTheBound) {
  std::vector<SmallerTable> tables(4);
  tables[0].bytes = 100;
  tables[1].bytes = 50;
  tables[1].cost.loss = 0.01;
  tables[2].bytes = 20;
  tables[2].cost.loss = 0.1;
  tables[3].bytes = 50;
  tables[3].cost.loss = 0.005;
  EXPECT_EQ(SmallestWithin(tables, Lookup::kBilinear, 0.02), &tables[3]);
  EXPECT_EQ(SmallestWithin(tables, Lookup::kBilinear, 0), &tables[0]);
  EXPECT_EQ(SmallestWithin(tables, Lookup::kNearest, 1), nullptr);
  SmallerTable& fewer_nodes = tables.emplace_back();
  fewer_nodes.nodes = 8;
  fewer_nodes.bytes = 1;
  EXPECT_FALSE(fewer_nodes.CanBeBaked());
  EXPECT_EQ(SmallestWithin(tables, Lookup::kBilinear, 0), &tables[0]);
  tables[0].eighth_bytes = 10;
  EXPECT_EQ(SmallestWithin(tables, Lookup::kBilinear, 0.02), &tables[0]);
}

}  // namespace
}  // namespace warplut
