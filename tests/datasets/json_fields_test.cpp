#include "datasets/json_fields.h"

#include <gtest/gtest.h>

#include <string>

#include "expect_error.h"

namespace warplut {
namespace {

std::string Nested(int depth, char open, char close) {
  return std::string(static_cast<std::size_t>(depth), open) +
         std::string(static_cast<std::size_t>(depth), close);
}

TEST(ParseJson, BoundsTheDepth) {
  const nlohmann::json deepest = ParseJson(Nested(kMaxJsonDepth, '[', ']'), "a.json");
  EXPECT_TRUE(deepest.is_array());
  for (const int depth : {kMaxJsonDepth + 1, 80'000, 1'000'000}) {
    ExpectError([&] { ParseJson(Nested(depth, '[', ']'), "a.json"); }, {"'a.json'", "64"});
  }
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  ExpectError([&] { ParseJson(objects, "a.json"); }, {"'a.json'", "64"});
}

TEST(ParseJson, NamesTheFileThatIsNotJson) {
  for (const char* text : {"", "{", "[1,]", "{\"a\": 1e999}", "nul", "\xff"}) {
    ExpectError([&] { ParseJson(text, "a.json"); }, {"'a.json' is not JSON"});
  }
}

TEST(ParseJson, RefusesAFieldThatIsThereTwice) {
  ExpectError([] { ParseJson(R"({"a": 1, "a": 2})", "a.json"); }, {"field 'a'", "twice"});
}

}  // namespace
}  // namespace warplut
