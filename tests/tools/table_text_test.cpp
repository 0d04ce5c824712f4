#include "tools/table_text.h"

#include <gtest/gtest.h>

namespace warplut {
namespace {

const TextTable kTable{.header = {"filter", "6 half"}, .rows = {{"keys", "0.9"}, {"a|b"}}};

TEST(TextTable, AlignsColumns) {
  EXPECT_EQ(ToText(kTable), "filter  6 half\nkeys       0.9\na|b\n");
}

TEST(TextTable, IsMarkdown) {
  EXPECT_EQ(ToMarkdown(kTable), "| filter | 6 half |\n|---|---:|\n| keys | 0.9 |\n| a\\|b |  |\n");
}

}  // namespace
}  // namespace warplut
