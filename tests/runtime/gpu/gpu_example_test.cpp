// The example for GPUs beside that for the processor.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

// The number behind "PSNR " of what a program prints, in dB.
double PrintedPsnr(const char* program) {
  FILE* pipe = popen(program, "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << program;
  const std::size_t at = text.find("PSNR ");
  EXPECT_NE(at, std::string::npos) << text;
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + 5, nullptr);
}

class GpuExample : public GpuTest {};

TEST_F(GpuExample, IsAsGoodAsTheProcessors) {
  const double cpu = PrintedPsnr(CPU_EXAMPLE);
  EXPECT_GT(cpu, 20);
  EXPECT_GT(PrintedPsnr(GPU_EXAMPLE), cpu - 0.02);
}

// A loader that finds no driver: one sentence, not a crash.
TEST(GpuExampleWithoutDevice, EndsWithASentence) {
  const std::string command =
      std::string("VK_ICD_FILENAMES=/none VK_DRIVER_FILES=/none ") + GPU_EXAMPLE + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2);
  EXPECT_NE(text.find("there is no Vulkan"), std::string::npos) << text;
}

}  // namespace
}  // namespace warplut
