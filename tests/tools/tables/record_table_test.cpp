#include "tools/tables/record_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace warplut {
namespace {

using testing::ElementsAre;

struct Row {
  std::string name;
  double milliseconds = 0;
  bool met = false;
};

const Columns<Row> kColumns = {
    {"name", "method", [](const Row& row) { return TextCell(row.name); }},
    {"ms", "ms", [](const Row& row) { return NumberCell(row.milliseconds, 1); }},
    {"met", "", [](const Row& row) { return Cell{.value = row.met, .text = "never shown"}; }},
    {"", "half", [](const Row& row) { return NumberCell(row.milliseconds / 2, 2); }}};
const std::vector<Row> kRows = {{"sr", 1.25, true},
                                {"i", std::numeric_limits<double>::infinity(), false}};

TEST(RecordTable, PeopleReadTheColumnsThatHaveAHeading) {
  const TextTable table = RecordTable(kColumns, kRows);
  EXPECT_THAT(table.header, ElementsAre("method", "ms", "half"));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_THAT(table.rows[0], ElementsAre("sr", "1.2", "0.62"));
  EXPECT_THAT(table.rows[1], ElementsAre("i", "-", "-"));
}

TEST(RecordTable, ProgramsReadTheColumnsThatHaveAKeyInTheirOrder) {
  EXPECT_EQ(RecordsJson(kColumns, kRows).dump(),
            R"([{"name":"sr","ms":1.25,"met":true},{"name":"i","ms":null,"met":false}])");
}

TEST(RecordTable, EqualImagesHaveNoFinitePsnr) {
  EXPECT_EQ(PsnrCell(31.256).text, "31.26");
  const Cell equal = PsnrCell(std::numeric_limits<double>::infinity());
  EXPECT_EQ(equal.text, "equal");
  EXPECT_TRUE(equal.value.is_null());
}

}  // namespace
}  // namespace warplut
