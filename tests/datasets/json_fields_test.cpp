#include "datasets/json_fields.h"

#include <gtest/gtest.h>

#include <string>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

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
  for (const char* text : {"", "{", "[1,]", "nul", "\xff"}) {
    ExpectError([&] { ParseJson(text, "a.json"); }, {"'a.json' is not JSON"});
  }
}

TEST(ParseJson, RefusesAFieldThatIsThereTwice) {
  ExpectError([] { ParseJson(R"({"a": 1, "a": 2})", "a.json"); }, {"field 'a'", "twice"});
}

TEST(ParseJson, BoundsTheMagnitudeOfNumbers) {
  EXPECT_EQ(ParseJson(R"({"a": [-1e38]})", "a.json")["a"][0], -1e38);
  for (const char* number : {"3.5e38", "-1e39", "1e308", "1e999", "-1e999"}) {
    const std::string text = std::string(R"({"b": 1, "a": [)") + number + "]}";
    ExpectError([&] { ParseJson(text, "a.json"); }, {"'a.json'", "'a'", "at most 3.40282e+38"});
  }
}

TEST(JsonPlace, TakesWholeNumbersHoweverTheyAreWritten) {
  const JsonPlace place("a.json", "n");
  for (const char* text : {"480", "480.0", "4.8e2"}) {
    EXPECT_EQ(place.Integer(ParseJson(text, "a.json")), 480) << text;
  }
  EXPECT_EQ(place.Integer(ParseJson("-2147483647.0", "a.json")), -2147483647);
  for (const char* text : {"480.5", "1e-3", "3e9", "-3e9", "1e38", "3000000000", "\"480\""}) {
    ExpectError([&] { place.Integer(ParseJson(text, "a.json")); }, {"'n'", "whole number"});
  }
}

TEST(ReadJson, BoundsTheSize) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.json", R"({"a": 1})");
  EXPECT_EQ(ReadJson(folder / "a.json")["a"], 1);
  ExpectError([&] { ReadJson(folder / "a.json", 5); }, {"a.json", "longer than 5 bytes"});
  std::string big = "[";
  big.resize(kMaxJsonBytes, ' ');
  WriteFile(folder / "big.json", big + "]");
  ExpectError([&] { ReadJson(folder / "big.json"); }, {"big.json", "longer than 16777216"});
}

TEST(JsonText, IsAlwaysUtf8) {
  EXPECT_EQ(JsonText(nlohmann::json{"caf\xe9", "caf\xc3\xa9"}),
            "[\"caf\xef\xbf\xbd\",\"caf\xc3\xa9\"]");
  EXPECT_EQ(JsonText(nlohmann::ordered_json{{"caf\xe9", 1}}), "{\"caf\xef\xbf\xbd\":1}");
}

TEST(RecordedName, IsOneLineOfUtf8) {
  EXPECT_EQ(RecordedName("a/b c.png"), "a/b c.png");
  EXPECT_EQ(RecordedName("caf\xc3\xa9"), "caf\xc3\xa9");
  EXPECT_EQ(RecordedName("caf\xe9\n\x7f"), "caf\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
}

}  // namespace
}  // namespace warplut
