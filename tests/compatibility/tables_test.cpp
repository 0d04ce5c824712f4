// Tables of every version load with the values that they were stored with, and headers compile.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "luts/bake/table_io.h"
#include "luts/fit/fit.h"
// clang-format off
#include "tests/compatibility/tables/version1_header.inc"
#include "tests/compatibility/tables/version2_recursive_header.inc"
// clang-format on

namespace warplut {
namespace {

namespace fs = std::filesystem;

const fs::path kReleased = WARPLUT_RELEASED;

// The integers that the table stores.
std::vector<int> Integers(const TableView& view) {
  std::vector<int> values;
  const auto* stored = static_cast<const std::int16_t*>(view.data);
  values.assign(stored, stored + TableValues(view.footprint));
  return values;
}

struct ReleasedTable {
  const char* file;
  const char* fit;  // that it was baked of
  double scale;
};

constexpr ReleasedTable kTables[] = {
    {"version1_i16", "version1_warp", 4},
    {"version1_sr", "version1_sr", 1.5},
    {"version2_recursive", "version2_recursive", 1.7},
    {"version2_taps24", "version2_taps24", 2},
};

class ReleasedTableTest : public testing::TestWithParam<ReleasedTable> {};

INSTANTIATE_TEST_SUITE_P(Tables, ReleasedTableTest, testing::ValuesIn(kTables),
                         [](const auto& test) { return std::string(test.param.file); });

TEST_P(ReleasedTableTest, LoadsAsItsFit) {
  const auto json = [](const char* folder, const char* name) {
    return kReleased / folder / (std::string(name) + ".json");
  };
  const LoadedTable table = LoadTable(json("tables", GetParam().file));
  EXPECT_EQ(table.scale, GetParam().scale);
  const LoadedTable baked = LoadTable(json("fits", GetParam().fit));
  EXPECT_EQ(table.name, baked.name);
  EXPECT_EQ(table.table.view().footprint, baked.table.view().footprint);
  EXPECT_EQ(table.table.view().prefilter.kind, baked.table.view().prefilter.kind);
  EXPECT_EQ(table.table.view().prefilter.side, baked.table.view().prefilter.side);
  EXPECT_EQ(Integers(table.table.view()), Integers(baked.table.view()));
}

TEST(ReleasedTables, HeadersAreTheSameTables) {
  const auto same = [](const TableView& header, const char* file) {
    const LoadedTable table = LoadTable(kReleased / "tables" / file);
    EXPECT_EQ(Integers(header), Integers(table.table.view())) << file;
    EXPECT_EQ(header.prefilter.kind, table.table.view().prefilter.kind) << file;
    EXPECT_EQ(header.prefilter.side, table.table.view().prefilter.side) << file;
  };
  same(baked::kWarplutX4, "version1_i16.json");
  same(baked::kWarplutIirX1_7, "version2_recursive.json");
}

// Nodes at i / 31 are resampled to i / 32: at whole offsets both have one, and between them the
// weights are smooth.
TEST(ReleasedTables, ExrLoadsAsTheTableOfItsFit) {
  constexpr int kFarthest = 64;  // of 2^14: 0.4 % of a weight
  const LoadedTable exr = LoadTable(kReleased / "tables" / "version1.exr");
  EXPECT_EQ(exr.scale, std::nullopt);
  const std::vector<int> resampled = Integers(exr.table.view());
  const std::vector<int> stored =
      Integers(LoadTable(kReleased / "tables" / "version1_i16.json").table.view());
  ASSERT_EQ(resampled.size(), stored.size());
  int farthest = 0;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    farthest = std::max(farthest, std::abs(resampled[i] - stored[i]));
  }
  EXPECT_LE(farthest, kFarthest);
  EXPECT_TRUE(std::equal(resampled.begin(), resampled.begin() + kTaps * kTaps, stored.begin()));
}

}  // namespace
}  // namespace warplut
