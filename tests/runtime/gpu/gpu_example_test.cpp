// The example for GPUs beside that for the processor, on the API of this program.
#include "tests/runtime/gpu/gpu_example.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/runtime/gpu/gpu_fixture.h"

namespace warplut {
namespace {

// The number behind "PSNR " of what a program prints, in dB.
double PrintedPsnr(const std::string& program) {
  const Printed printed = OutputOf(program);
  EXPECT_EQ(printed.code, 0) << program;
  const std::size_t at = printed.text.find("PSNR ");
  EXPECT_NE(at, std::string::npos) << printed.text;
  return at == std::string::npos ? 0 : std::strtod(printed.text.c_str() + at + 5, nullptr);
}

class GpuExample : public GpuTest {};

TEST_F(GpuExample, IsAsGoodAsTheProcessors) {
  const double cpu = PrintedPsnr(CPU_EXAMPLE);
  EXPECT_GT(cpu, 20);
  EXPECT_GT(PrintedPsnr(kGpuExample), cpu - 0.02);
}

// A loader that finds no driver: one sentence, not a crash.
TEST(GpuExampleWithoutDevice, EndsWithASentence) {
  const bool is_gles = kTestedApi == GpuApi::kGles;
  const Printed printed = OutputOf((is_gles ? "__EGL_VENDOR_LIBRARY_FILENAMES=/none "
                                            : "VK_ICD_FILENAMES=/none VK_DRIVER_FILES=/none ") +
                                   kGpuExample);
  EXPECT_EQ(printed.code, 2);
  EXPECT_NE(printed.text.find(is_gles ? "there is no OpenGL ES" : "there is no Vulkan"),
            std::string::npos)
      << printed.text;
  EXPECT_EQ(printed.text.find('\n'), printed.text.size() - 1);
}

}  // namespace
}  // namespace warplut
