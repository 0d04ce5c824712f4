// The scripts that check and rewrite sources and pages, on small projects of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/program.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kTools = WARPLUT_SOURCE "/tools";

// A folder with a page, and a copy of some scripts, which work on the project that they lie in.
class Pages : public testing::Test {
 protected:
  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    WriteFile(root_ / name, text);
  }
  std::string Read(const std::string& name) const { return ReadFile(root_ / name); }
  void Copy(const std::string& script) const {
    const fs::path copy = root_ / ("tools/" + script);
    fs::create_directories(copy.parent_path());
    fs::copy_file(kTools / script, copy);
  }
  ProgramResult Run(const std::string& script, const std::vector<std::string>& arguments) const {
    return RunProgram(root_ / ("tools/" + script), arguments);
  }
  ProgramResult CheckStyle() const { return RunProgram(kTools / "check_style.sh", {Root()}); }
  std::string Root() const { return root_.path(); }

  const TemporaryFolder root_;
};

TEST_F(Pages, TablesBetweenMarkersAreRewritten) {
  Copy("measure/update_tables.sh");
  Copy("measure/gains_table.awk");
  Write("README.md", "a\n<!-- table: gains -->\n<!-- end -->\nb\n");
  Write("docs/page.md", "<!-- table: other -->\nkept\n<!-- end -->\n");
  Write("docs/results/pipeline.md",
        "<!-- table: pipeline-defaults-rendered -->\n| mean | PSNR dB |\n|---|---:|\n"
        "| sr | 33.5 |\n| bilinear | 30.25 |\n<!-- end -->\n");
  Write("docs/results/resampling.md",
        "c\n<!-- table: quickstart-held-out -->\nold\n<!-- end -->\nd\n");
  Write("tables/quickstart-held-out.md",
        "| SSIM after | 24 half | 24 pan | 64 pan |\n|---|---:|---:|---:|\n"
        "| catmull-rom | 0.5 | 0.7 | 0.1 |\n| warplut_iir_x2 | 0.75 | 0.95 | 0.9 |\n");
  const ProgramResult result = Run("measure/update_tables.sh", {Root() + "/tables"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(Read("docs/results/resampling.md"),
              testing::AllOf(HasSubstr("c\n"), HasSubstr("| 0.5 |"), HasSubstr("\nd\n"),
                             testing::Not(HasSubstr("old"))));
  EXPECT_THAT(Read("docs/page.md"), HasSubstr("kept"));
  EXPECT_EQ(Read("README.md"),
            "a\n<!-- table: gains -->\n"
            "| | without | with warplut | gain |\n|---|---:|---:|---:|\n"
            "| SSIM after 24 warps, against Catmull-Rom | 0.600 | 0.850 | +0.250 |\n"
            "| PSNR of super resolution x2, against bilinear | 30.25 | 33.50 | +3.25 |\n"
            "<!-- end -->\nb\n");
}

TEST_F(Pages, ProgramsOnPagesAreThoseOfTheirFiles) {
  Copy("update_examples.sh");
  Write("README.md", "x\n");
  Write("program.cpp", "int main() {}\n");
  Write("docs/page.md", "<!-- file: program.cpp -->\nold\n<!-- end -->\n");
  const ProgramResult differs = Run("update_examples.sh", {"--check"});
  EXPECT_EQ(differs.code, 1);
  EXPECT_THAT(differs.err, HasSubstr("docs/page.md"));
  EXPECT_EQ(Run("update_examples.sh", {}).code, 0);
  EXPECT_EQ(Read("docs/page.md"),
            "<!-- file: program.cpp -->\n```cpp\nint main() {}\n```\n<!-- end -->\n");
  EXPECT_EQ(Run("update_examples.sh", {"--check"}).code, 0);
  Write("docs/page.md", "<!-- file: absent.cpp -->\n<!-- end -->\n");
  EXPECT_NE(Run("update_examples.sh", {"--check"}).code, 0);
}

TEST_F(Pages, EachFaultOfStyleIsNamed) {
  Write("README.md", "[a](docs/page.md) [b](docs/absent.md) and `docs/lost.md`\n");
  Write("docs/page.md", "short\n    " + std::string(120, 'c') + "\n| " + std::string(120, 't') +
                            " |\n" + std::string(101, 'w') + "\n");
  Write("luts/a.h", "#include \"runtime/b.h\"\n");
  Write("runtime/b.h", "#include \"luts/a.h\"\nint  unformatted;\n");
  Write("runtime/long.h", std::string(401, '\n'));
  Write("tools/script.sh", "#!/bin/sh\necho $1\n");
  const ProgramResult result = CheckStyle();
  EXPECT_EQ(result.code, 1);
  for (const char* fault :
       {"README.md:1: the link leads to docs/absent.md", "README.md:1: names docs/lost.md",
        "docs/page.md:4: 101 columns", "runtime/long.h:401: "}) {
    EXPECT_THAT(result.out, HasSubstr(fault));
  }
  for (const char* fine : {"page.md:2", "page.md:3", "b.h:1", "docs/page.md, which"}) {
    EXPECT_THAT(result.out, testing::Not(HasSubstr(fine)));
  }
  if (result.err.find("shellcheck") == std::string::npos) {
    EXPECT_THAT(result.out, HasSubstr("tools/script.sh:2:"));
  }
  if (result.err.find("clang-format") == std::string::npos) {
    EXPECT_THAT(result.out, HasSubstr("runtime/b.h:2:"));
  }
}

TEST_F(Pages, AProjectWithoutFaultsPasses) {
  Write("README.md", "[a](docs/page.md)\n");
  Write("docs/page.md", "short\n");
  Write("luts/a.h", "// A header.\n#pragma once\n");
  const ProgramResult result = CheckStyle();
  EXPECT_EQ(result.code, 0) << result.out;
  EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace warplut
