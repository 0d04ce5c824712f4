#include "runtime/gpu/gles/gles_device.h"

#include <gtest/gtest.h>

#include "runtime/gpu/gles/gles_program.h"
#include "runtime/gpu/gpu_frame_generation.h"
#include "tests/runtime/gpu/gpu_example.h"

namespace warplut {
namespace {

TEST(SpecialisedSource, HasTheValuesOfTheConstantsThatItNames) {
  const std::string source =
      "#version 310 es\n"
      "#ifndef SPIRV_CROSS_CONSTANT_ID_1\n#define SPIRV_CROSS_CONSTANT_ID_1 7\n#endif\n"
      "#ifndef SPIRV_CROSS_CONSTANT_ID_10\n#define SPIRV_CROSS_CONSTANT_ID_10 true\n#endif\n";
  const std::vector<std::int32_t> constants = {1, -5, 2, 3, 4, 5, 6, 7, 8, 9, 0};
  const std::string specialised = SpecialisedSource(source, constants);
  EXPECT_NE(specialised.find("#define SPIRV_CROSS_CONSTANT_ID_1 -5\n"), std::string::npos);
  EXPECT_NE(specialised.find("#define SPIRV_CROSS_CONSTANT_ID_10 false\n"), std::string::npos);
  EXPECT_EQ(SpecialisedSource(source, {}), source);
}

class GlesDeviceTest : public GpuTest {
 protected:
  static const GlesDevice& gles() { return dynamic_cast<const GlesDevice&>(device()); }
};

TEST_F(GlesDeviceTest, AShaderThatDoesNotCompileIsOneSentence) {
  const GlesDevice::Current current(gles());
  try {
    MakeProgram(gles(), "wrong", "#version 310 es\nvoid main() { this is no shader }\n");
    FAIL() << "it compiled";
  } catch (const GpuError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find("the GPU failed to compile the pass wrong: "), 0U) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
  ForgetMessages();
}

TEST_F(GlesDeviceTest, AWrongCallIsOneSentence) {
  const GlesDevice::Current current(gles());
  gles().Check("to do nothing");
  gles().gl().Enable(0);
  try {
    gles().Check("to run a frame");
    FAIL() << "it was right";
  } catch (const GpuError& error) {
    EXPECT_STREQ(error.what(), "the GPU failed to run a frame: OpenGL ES returned 1280");
  }
  ForgetMessages();
}

// Mesa plays an older version where it is told to.
TEST_F(GlesDeviceTest, AnOlderVersionIsOneSentence) {
  const Printed printed = OutputOf("MESA_GLES_VERSION_OVERRIDE=3.1 " + kGpuExample);
  if (printed.code == 0) GTEST_SKIP() << "the driver is not Mesa's";
  EXPECT_EQ(printed.code, 2);
  EXPECT_EQ(printed.text,
            "the OpenGL ES driver of this machine has not version 3.2, which was expected\n");
}

TEST_F(GlesDeviceTest, KeysThatTheDeviceCannotHoldAreRefused) {
  FrameGenerationOptions options;
  options.width = options.height = gles().largest_image();
  std::string why;
  if (SplatKeyBytes(options) <= gles().largest_buffer()) GTEST_SKIP() << "the device holds them";
  EXPECT_FALSE(GpuFrameGeneration::IsRunnable(device(), options, &why));
  EXPECT_EQ(why.find("the keys of splatting take "), 0U) << why;
  options.splat = false;
  EXPECT_TRUE(GpuFrameGeneration::IsRunnable(device(), options, &why)) << why;
}

}  // namespace
}  // namespace warplut
