#include "tools/tables/table_text.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

const TextTable kTable{.header = {"filter", "6 half"}, .rows = {{"keys", "0.9"}, {"a|b"}}};

TEST(TextTable, AlignsColumns) {
  EXPECT_EQ(ToText(kTable), "filter  6 half\nkeys       0.9\na|b\n");
}

TEST(TextTable, AlignsAsManyColumnsLeftAsAreAskedFor) {
  TextTable table{.header = {"a", "motion", "ms"}, .rows = {{"b", "x", "1"}}, .left = 2};
  EXPECT_EQ(ToText(table), "a  motion  ms\nb  x        1\n");
  EXPECT_EQ(ToMarkdown(table), "| a | motion | ms |\n|---|---|---:|\n| b | x | 1 |\n");
}

TEST(TextTable, IsMarkdown) {
  EXPECT_EQ(ToMarkdown(kTable), "| filter | 6 half |\n|---|---:|\n| keys | 0.9 |\n| a\\|b |  |\n");
}

}  // namespace
}  // namespace warplut
