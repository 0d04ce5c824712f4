// The shell scripts, where they can be tested without installing or building anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

const std::string kTools = WARPLUT_SOURCE "/tools/";

TEST(Scripts, RefuseUnknownOptions) {
  for (const char* script : {"test.sh", "quickstart.sh", "install_dependencies.sh",
                             "update_examples.sh", "check_style.sh"}) {
    const ProgramResult result = RunProgram(kTools + script, {"--nonsense"});
    EXPECT_EQ(result.code, 1) << script;
    EXPECT_THAT(result.err,
                testing::AllOf(testing::HasSubstr(script), testing::HasSubstr("--nonsense")));
  }
}

TEST(Scripts, TheListOfPackagesNamesEachOnce) {
  const ProgramResult result = RunProgram(kTools + "install_dependencies.sh", {"--list"});
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, testing::HasSubstr("libceres-dev\n"));
}

std::string SummaryOf(const std::string& report, const std::string& what) {
  return RunProgram("/usr/bin/awk",
                    {"-f", kTools + "junit_summary.awk", "-v", "what=" + what, report})
      .out;
}

TEST(Scripts, SummaryCountsPassedFailedAndSkipped) {
  const TemporaryFolder folder;
  WriteFile(folder / "junit.xml",
            "<testsuite>\n"
            "\t<testcase name=\"A.Pass\" status=\"run\">\n\t</testcase>\n"
            "\t<testcase name=\"A.Fail\" status=\"fail\">\n\t\t<failure message=\"\"/>\n"
            "\t\t<system-out>1 &lt; 0</system-out>\n\t</testcase>\n"
            "\t<testcase name=\"A.Skip\" status=\"notrun\">\n"
            "\t\t<skipped message=\"SKIP_REGULAR_EXPRESSION_MATCHED\"/>\n"
            "\t\t<system-out>a_test.cpp:4: Skipped\nno data\n</system-out>\n\t</testcase>\n"
            "\t<testcase name=\"A.Absent\" status=\"notrun\">\n"
            "\t\t<skipped message=\"Unable to find executable\"/>\n\t</testcase>\n"
            "</testsuite>\n");
  EXPECT_EQ(SummaryOf(folder / "junit.xml", "counts"), "1 2 1\n");
  EXPECT_THAT(SummaryOf(folder / "junit.xml", "details"),
              testing::AllOf(testing::HasSubstr("1 < 0"), testing::HasSubstr("A.Skip: no data")));
}

TEST(Scripts, SummaryCountsTheTestsOfASuite) {
  const TemporaryFolder folder;
  const std::string ended =
      "\t<testcase name=\"A.all\" status=\"fail\">\n\t\t<failure message=\"\"/>\n"
      "\t\t<system-out>Note: Google Test filter = A.*\n"
      "[ RUN      ] A.Pass\n[       OK ] A.Pass (3 ms)\n"
      "[ RUN      ] A.Fail\n1 &lt; 0\n[  FAILED  ] A.Fail, where GetParam() = 2 (0 ms)\n"
      "[ RUN      ] A.Skip\na_test.cpp:4: Skipped\nno data\n\n[  SKIPPED ] A.Skip (1 ms)\n"
      "[  PASSED  ] 1 test.\n[  FAILED  ] 1 test, listed below:\n"
      "[  FAILED  ] A.Fail, where GetParam() = 2\n</system-out>\n\t</testcase>\n";
  const std::string died =
      "\t<testcase name=\"B.all\" status=\"fail\">\n\t\t<failure message=\"\"/>\n"
      "\t\t<system-out>[ RUN      ] B.Pass\n[       OK ] B.Pass (3 ms)\n"
      "[ RUN      ] B.Dies\nSegmentation fault\n</system-out>\n\t</testcase>\n";
  WriteFile(folder / "junit.xml", "<testsuite>\n" + ended + died + "</testsuite>\n");
  EXPECT_EQ(SummaryOf(folder / "junit.xml", "counts"), "2 2 1\n");
  EXPECT_THAT(SummaryOf(folder / "junit.xml", "details"),
              testing::AllOf(testing::HasSubstr("1 < 0"), testing::HasSubstr("A.Skip: no data"),
                             testing::HasSubstr("failed: B.Dies")));
}

}  // namespace
}  // namespace warplut
