// What a PIPELINE.h leaves out of the runtime, and that nothing else changes.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace warplut {
namespace {

// The programs of pipeline_images.cpp, by the name of their configuration.
const std::map<std::string, std::string> kPrograms = {{"full", PIPELINE_full},
                                                      {"sample", PIPELINE_sample},
                                                      {"interpolation", PIPELINE_interpolation},
                                                      {"static", PIPELINE_static},
#ifdef PIPELINE_fast_math
                                                      {"fast-math", PIPELINE_fast_math}
#endif
};
constexpr const char* kLean[] = {"sample", "interpolation", "static"};

// Lines that a command prints.
std::vector<std::string> Lines(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<std::string> lines(1);
  for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += static_cast<char>(c);
    }
  }
  lines.pop_back();
  return lines;
}

// What a program prints for a configuration: the hash and the bytes, or the sentence, of each part.
struct Result {
  std::string hash;
  std::size_t bytes = 0;
  std::string refused;
};

std::map<std::string, Result> ResultsOf(const std::string& program,
                                        const std::string& configuration) {
  std::map<std::string, Result> results;
  for (const std::string& line :
       Lines(EMULATOR " " + kPrograms.at(program) + " " + configuration)) {
    std::istringstream text(line);
    std::string part;
    Result result;
    text >> part >> result.hash;
    if (result.hash == "refused:") {
      std::getline(text, result.refused);
    } else {
      text >> result.bytes;
    }
    results[part] = result;
  }
  return results;
}

TEST(Pipelines, LeanImagesAreThoseOfTheFullRuntimeWithThePassesSwitchedOff) {
  for (const std::string name : kLean) {
    const auto lean = ResultsOf(name, name);
    const auto full = ResultsOf("full", name);
    ASSERT_EQ(lean.size(), 1u) << name;
    for (const auto& [part, result] : lean) {
      SCOPED_TRACE(name + " " + part);
      EXPECT_EQ(result.refused, "");
      EXPECT_EQ(result.hash, full.at(part).hash);
      EXPECT_EQ(full.at(part).refused, "");
      EXPECT_LE(result.bytes, full.at(part).bytes);
    }
  }
}

// The interpolation of the lean runtime, compiled in a project with -ffast-math.
TEST(Pipelines, FastMathOfAProjectChangesNothing) {
#ifndef PIPELINE_fast_math
  GTEST_SKIP() << "the compiler has no -ffast-math";
#else
  const auto fast = ResultsOf("fast-math", "interpolation");
  const auto strict = ResultsOf("interpolation", "interpolation");
  ASSERT_EQ(fast.size(), 1u);
  EXPECT_EQ(fast.at("interpolation").hash, strict.at("interpolation").hash);
  EXPECT_NE(fast.at("interpolation").hash, "");
#endif
}

TEST(Pipelines, LeanBuffersAreFewerThanThoseOfTheDefaults) {
  const auto full = ResultsOf("full", "full");
  EXPECT_LT(ResultsOf("sample", "sample").at("super_resolution").bytes,
            0.7 * static_cast<double>(full.at("super_resolution").bytes));
  EXPECT_LT(ResultsOf("static", "static").at("super_resolution").bytes,
            0.6 * static_cast<double>(full.at("super_resolution").bytes));
  EXPECT_LT(ResultsOf("interpolation", "interpolation").at("interpolation").bytes,
            full.at("interpolation").bytes);
}

TEST(Pipelines, LeanBuildsRefuseWhatTheyDoNotContain) {
  EXPECT_EQ(ResultsOf("sample", "static").at("super_resolution").refused,
            " The form is residual; this build contains sample alone.");
  EXPECT_EQ(ResultsOf("static", "sample").at("super_resolution").refused,
            " The form is sample; this build contains residual alone.");
  EXPECT_TRUE(ResultsOf("interpolation", "sample").empty());
}

// Bytes of the runtime's functions in a program, by their names.
std::map<std::string, std::size_t> Functions(const std::string& program) {
  std::map<std::string, std::size_t> functions;
  for (const std::string& line : Lines(NM " -C -S --defined-only " + kPrograms.at(program))) {
    std::istringstream text(line);
    std::string address, size, type, name;
    text >> address >> size >> type;
    std::getline(text, name);
    const bool is_code = type == "t" || type == "T" || type == "w" || type == "W";
    if (!is_code || name.find("warplut::") == std::string::npos) continue;
    functions[name] += std::strtoul(size.c_str(), nullptr, 16);
  }
  return functions;
}

bool HasFunction(const std::map<std::string, std::size_t>& functions, const std::string& name) {
  for (const auto& [function, size] : functions) {
    if (function.find("::" + name + "(") != std::string::npos) return true;
  }
  return false;
}

std::size_t Size(const std::map<std::string, std::size_t>& functions) {
  std::size_t sum = 0;
  for (const auto& [function, size] : functions) sum += size;
  return sum;
}

class PipelineCode : public testing::Test {
 protected:
  void SetUp() override {
#if !defined(__OPTIMIZE__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "what is left out shows in optimised code alone";
#endif
    if (Functions("full").empty()) GTEST_SKIP() << NM << " lists no functions";
  }
};

TEST_F(PipelineCode, PassesThatAreLeftOutHaveNoSymbols) {
  const std::map<std::string, std::vector<std::string>> absent = {
      {"sample",
       {"Residual", "FilterRow", "SplatRow", "TargetMotionRow", "ForwardRow", "BlendRow",
        "PredictReference", "UpdateReference", "WarpReferencePixels", "RepairRow", "EncodeHdrRow",
        "LimitHdrRow", "PrefilterTile"}},
      {"interpolation",
       {"FillPlanes", "Predict", "Residual", "Update", "DepthRange", "FilterRow", "OwnMotionRow",
        "SplatRowReference", "BlendRowReference", "RepairRow", "EncodeHdrRow", "LimitHdrRow"}},
      {"static",
       {"DepthRange", "FilterRow", "SplatRow", "BlendRow", "WarpGeneral", "WarpUniform", "WarpRows",
        "ClassifyTile", "PredictReference"}}};
  const auto full = Functions("full");
  for (const auto& [program, names] : absent) {
    const auto functions = Functions(program);
    for (const std::string& name : names) {
      EXPECT_TRUE(HasFunction(full, name)) << name;
      EXPECT_FALSE(HasFunction(functions, name)) << program << " " << name;
    }
  }
}

TEST_F(PipelineCode, IsSmaller) {
  const double full = static_cast<double>(Size(Functions("full")));
  const std::map<std::string, double> shares = {
      {"sample", 0.3}, {"interpolation", 0.3}, {"static", 0.22}};
  for (const auto& [program, share] : shares) {
    const auto size = static_cast<double>(Size(Functions(program)));
    RecordProperty(program, std::to_string(size / full));
    EXPECT_LT(size, share * full) << program << " of " << full;
  }
}

}  // namespace
}  // namespace warplut
