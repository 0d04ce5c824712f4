#include "train/replay/parameters_file.h"

#include <gtest/gtest.h>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

class ParametersFile : public testing::Test {
 protected:
  std::string Write(const std::string& text) const {
    WriteFile(folder_ / "p.json", text);
    return folder_ / "p.json";
  }
  void ExpectRefused(const std::string& text, const std::string& piece) const {
    const std::string path = Write(text);
    ExpectError([&] { ReadParameters(path); }, {"p.json", piece});
  }

  const TemporaryFolder folder_;
};

TEST_F(ParametersFile, ReadsBackTheSameBits) {
  Parameters parameters;
  for (const ParameterInfo& info : kParameters) {
    parameters.*info.member = info.min + (info.max - info.min) / 3;
  }
  EXPECT_EQ(ReadParameters(Write(ParametersJson(parameters, ""))), parameters);
  EXPECT_EQ(ReadParameters(Write(ParametersJson(kPaperParameters, R"({"runs": 12})"))),
            kPaperParameters);
  EXPECT_EQ(ParametersJson(parameters, ""), ParametersJson(parameters, ""));
}

TEST_F(ParametersFile, WritesNumbersAsPeopleDo) {
  EXPECT_NE(ParametersJson(kPaperParameters, "").find("\"blend_a\": 0.34,"), std::string::npos);
}

TEST_F(ParametersFile, KeepsDefaultsOfWhatIsNotNamed) {
  Parameters expected;
  expected.blend_b = 1.5f;
  EXPECT_EQ(ReadParameters(Write(R"({"format": "warplut-parameters", "version": 1,
                                     "parameters": {"blend_b": 1.5}})")),
            expected);
}

TEST_F(ParametersFile, RefusesWhatItDoesNotKnow) {
  const std::string head = R"({"format": "warplut-parameters", "version": 1, "parameters": )";
  ExpectRefused("{", "JSON");
  ExpectRefused(R"({"format": "warplut-fit", "version": 1, "parameters": {}})", "format");
  ExpectRefused(R"({"format": "warplut-parameters", "version": 2, "parameters": {}})", "version");
  ExpectRefused(R"({"format": "warplut-parameters", "version": 1})", "parameters");
  ExpectRefused(head + "[]}", "parameters");
  ExpectRefused(head + R"({"blend_c": 1}})", "blend_c");
  ExpectRefused(head + R"({"blend_a": "1"}})", "a number");
  ExpectRefused(head + R"({"blend_a": 100}})", "0.02 to 8");
  ExpectRefused(head + R"({"blend_a": 1, "blend_a": 2}})", "twice");
  ExpectRefused(head + R"({}, "comment": ""})", "comment");
}

TEST(ParametersJson, RefusesWhatCannotBeRead) {
  Parameters wrong;
  wrong.blend_a = -1;
  ExpectError([&] { ParametersJson(wrong, ""); }, {"blend_a"});
  ExpectError([&] { ParametersJson({}, "[1]"); }, {"[1]", "object"});
  ExpectError([&] { ParametersJson({}, "{"); }, {"object"});
}

}  // namespace
}  // namespace warplut
