#include "tools/memory_size.h"

#include <gtest/gtest.h>

#include "tests/datasets/expect_error.h"

namespace warplut {
namespace {

TEST(MemorySize, IsANumberAndAUnit) {
  EXPECT_EQ(ParseMemorySize(""), 0U);
  EXPECT_EQ(ParseMemorySize("3K"), 3U << 10);
  EXPECT_EQ(ParseMemorySize("500M"), std::size_t{500} << 20);
  EXPECT_EQ(ParseMemorySize("2G"), std::size_t{2} << 30);
}

TEST(MemorySize, RefusesAnythingElse) {
  for (const char* text : {"0M", "500", "-1G", "1.5G", "2g", "G", "2GB", " 2G", "2 G",
                           "99999999999999999999G", "1073741825G"}) {
    ExpectError([&] { ParseMemorySize(text); }, {std::string("'") + text + "'", "500M"});
  }
}

}  // namespace
}  // namespace warplut
