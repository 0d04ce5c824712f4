#include "luts/fit/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/luts/test_fits.h"

namespace warplut {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

class FitTest : public testing::Test {
 protected:
  const std::filesystem::path path_ = TestFolder() / "fit.json";

  // The sentence on reading a valid file that `change` has spoilt.
  template <class Change>
  std::string SentenceAfter(const Change& change) {
    WriteFit(path_, MakeFit(1));
    ordered_json json = ordered_json::parse(ReadFile(path_));
    change(json);
    WriteFile(path_, json.dump());
    const std::string sentence = SentenceOf([&] { ReadFit(path_); });
    EXPECT_THAT(sentence, HasSubstr(path_.string()));
    return sentence;
  }
};

TEST_F(FitTest, SurvivesARoundTrip) {
  Fit fit = MakeFit(3);
  fit.seed = std::numeric_limits<std::uint64_t>::max();
  fit.parameters[5] = 5e-324;
  WriteFit(path_, fit);
  const Fit read = ReadFit(path_);
  EXPECT_EQ(read.name, fit.name);
  EXPECT_EQ(read.scale, fit.scale);
  EXPECT_EQ(read.objective, fit.objective);
  EXPECT_EQ(read.optimizer, fit.optimizer);
  EXPECT_EQ(read.horizons, fit.horizons);
  EXPECT_EQ(read.gain_bound, fit.gain_bound);
  EXPECT_EQ(read.keys_a, fit.keys_a);
  EXPECT_EQ(read.seed, fit.seed);
  EXPECT_EQ(read.options, fit.options);
  EXPECT_EQ(read.parameters, fit.parameters);
  ASSERT_EQ(read.data.size(), 1u);
  EXPECT_EQ(read.data[0].name, fit.data[0].name);
  EXPECT_EQ(read.data[0].sha1, fit.data[0].sha1);
  EXPECT_EQ(read.data[0].width, 960);
  EXPECT_EQ(read.data[0].height, 540);
  ASSERT_EQ(read.loss.size(), 2u);
  EXPECT_EQ(read.loss[1].seconds, 1.0 / 3);
  EXPECT_EQ(read.loss[1].evaluations, 20);
  ASSERT_EQ(read.validation.size(), 2u);
  EXPECT_EQ(read.validation[1].filter, "keys");
  EXPECT_EQ(read.validation[1].warps, 6);
  EXPECT_EQ(read.validation[1].ssim, 0.98);
}

TEST_F(FitTest, SameFitGivesSameBytes) {
  WriteFit(path_, MakeFit(1));
  const std::string first = ReadFile(path_);
  WriteFit(path_, ReadFit(path_));
  EXPECT_EQ(ReadFile(path_), first);
}

TEST_F(FitTest, ReadingRefusesAWrongFile) {
  EXPECT_THAT(SentenceOf([&] { ReadFit(path_); }), HasSubstr(path_.string()));
  WriteFile(path_, "{");
  EXPECT_THAT(SentenceOf([&] { ReadFit(path_); }), HasSubstr("is not JSON"));
  WriteFile(path_, "[]");
  EXPECT_THAT(SentenceOf([&] { ReadFit(path_); }), HasSubstr("expected an object"));
  WriteFile(path_, std::string((std::size_t{16} << 20) + 1, ' '));
  EXPECT_THAT(SentenceOf([&] { ReadFit(path_); }), HasSubstr("16777216"));
}

TEST_F(FitTest, ReadingNamesTheField) {
  EXPECT_THAT(SentenceAfter([](auto& j) { j["format"] = "warplut-table"; }),
              HasSubstr("field 'format' is \"warplut-table\"; expected \"warplut-fit\""));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["version"] = 3; }),
              HasSubstr("field 'version' is 3; expected 1 to 2"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j.erase("seed"); }),
              HasSubstr("field 'seed' is missing"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["data"][0].erase("sha1"); }),
              HasSubstr("field 'data[0].sha1' is missing"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["author"] = 1; }),
              HasSubstr("field 'author' is unknown"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["loss"][1]["rate"] = 1; }),
              HasSubstr("field 'loss[1].rate' is unknown"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["scale"] = "2"; }),
              HasSubstr("field 'scale' is \"2\"; expected a number"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["name"] = 2; }),
              HasSubstr("field 'name' is 2; expected a text"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["horizons"] = 6; }),
              HasSubstr("field 'horizons' is 6; expected values"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["horizons"][0] = 6.5; }),
              HasSubstr("field 'horizons[0]' is 6.5; expected a whole number"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["seed"] = -1; }),
              HasSubstr("field 'seed' is -1; expected a whole number of at least 0"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["parameters"][3] = nullptr; }),
              HasSubstr("field 'parameters[3]' is null; expected a number"));
  EXPECT_THAT(SentenceAfter([](auto& j) { j["parameters"].erase(0); }),
              HasSubstr("field parameters has 3743 values, expected 3744"));
  EXPECT_THAT(
      SentenceAfter([](auto& j) {
        j["horizons"] = {6, 12, 12};
      }),
      HasSubstr("field horizons[2] is 12, expected ascending numbers, here one in [13, 1024]"));
}

TEST_F(FitTest, WritingRefusesAFitThatIsNotValid) {
  const auto sentence_after = [&](auto change) {
    Fit fit = MakeFit(1);
    change(fit);
    std::string why;
    EXPECT_FALSE(fit.IsValid(&why));
    const std::string sentence = SentenceOf([&] { WriteFit(path_, fit); });
    EXPECT_THAT(sentence, HasSubstr(path_.string()));
    EXPECT_THAT(sentence, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(path_));
    return why;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(sentence_after([](Fit& f) { f.name = std::string("1x"); }),
              HasSubstr("name is \"1x\""));
  EXPECT_THAT(sentence_after([](Fit& f) { f.name = std::string(""); }), HasSubstr("name is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.scale = 0.5; }), HasSubstr("scale is 0.5"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.objective = std::string("x"); }),
              HasSubstr("objective is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.optimizer = std::string("x"); }),
              HasSubstr("optimizer is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.horizons = {}; }), HasSubstr("horizons is empty"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.horizons = {0}; }), HasSubstr("horizons[0] is 0"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.horizons = {1025}; }),
              HasSubstr("horizons[0] is 1025"));
  EXPECT_THAT(sentence_after([&](Fit& f) { f.gain_bound = nan; }), HasSubstr("gain_bound is nan"));
  EXPECT_THAT(sentence_after([&](Fit& f) { f.keys_a = nan; }), HasSubstr("keys_a is nan"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.options = std::string("{\n}"); }),
              HasSubstr("options is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.options = std::string(""); }), HasSubstr("options is"));
  EXPECT_THAT(sentence_after([&](Fit& f) { f.parameters[9] = nan; }),
              HasSubstr("parameters[9] is nan"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.data[0].name = std::string("/a"); }),
              HasSubstr("data[0].name is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.data[0].sha1 = std::string("A"); }),
              HasSubstr("data[0].sha1 is"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.data[0].width = 0; }), HasSubstr("data[0] is 0 x 540"));
  EXPECT_THAT(sentence_after([&](Fit& f) { f.loss[1].loss = nan; }),
              HasSubstr("loss[1] has a value"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.loss[1].seconds = -1; }),
              HasSubstr("loss[1] has negative"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.validation[0].filter = std::string("x"); }),
              HasSubstr("validation[0].filter"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.validation[0].offsets = std::string("x"); }),
              HasSubstr("validation[0].offsets"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.validation[0].warps = 0; }),
              HasSubstr("validation[0].warps is 0"));
  EXPECT_THAT(sentence_after([](Fit& f) { f.validation[0].ssim = 2; }),
              HasSubstr("validation[0].ssim is 2"));
}

TEST_F(FitTest, TellsWhetherATimeLimitCutIt) {
  Fit fit = MakeFit(0);
  WriteFit(path_, fit);
  EXPECT_FALSE(ReadFit(path_).cut);
  EXPECT_EQ(ReadFile(path_).find("ended"), std::string::npos);
  fit.cut = true;
  WriteFit(path_, fit);
  EXPECT_TRUE(ReadFit(path_).cut);
  std::string text = ReadFile(path_);
  text.replace(text.find("time limit"), 10, "lunch time");
  WriteFile(path_, text);
  EXPECT_THAT(SentenceOf([&] { ReadFit(path_); }), HasSubstr("'ended' is \"lunch time\""));
}

TEST_F(FitTest, WritesTextThatIsNotUtf8WithReplacements) {
  Fit fit = MakeFit(0);
  fit.data = {{"caf\xe9.png", std::string(40, '0'), 8, 8}};
  WriteFit(path_, fit);
  EXPECT_EQ(ReadFit(path_).data[0].name, "caf\xef\xbf\xbd.png");
}

TEST(IsIdentifier, TakesLettersDigitsAndUnderscoresThatBeginWithNoDigit) {
  for (const char* text : {"a", "_", "warplut_x1_3", "Z9"}) EXPECT_TRUE(IsIdentifier(text)) << text;
  for (const char* text : {"", "1x", "a-b", "a b", "a.b", "\xc3\xa9"})
    EXPECT_FALSE(IsIdentifier(text)) << text;
}

}  // namespace
}  // namespace warplut
