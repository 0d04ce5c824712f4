// Counts what is allocated while frames are generated.
#include "tests/runtime/counted_allocations.h"
#include "tests/runtime/generation/generation_fixture.h"

namespace warplut::generation {
namespace {

TEST(FrameGeneration, AllocatesNothing) {
  const TestFrame frame0 = RandomFrame(70, 41, PixelFormat::kRgba16F, 1);
  const TestFrame frame1 = RandomFrame(70, 41, PixelFormat::kRgba16F, 2);
  ThreadPool pool(2);
  TestImage out(70, 41, PixelFormat::kRgba16F);
  for (const ColorEncoding encoding : {ColorEncoding::kDisplay, ColorEncoding::kLinearHdr}) {
    FrameGenerationOptions options = OptionsFor(frame0);
    options.encoding = encoding;
    FrameGeneration generation(options, pool);
    const int before = CountedAllocations();
    generation.Interpolate(frame0.view(), frame1.view(), 0.5f, out.view());
    generation.Extrapolate(frame0.view(), frame1.view(), 0.5f, out.view());
    EXPECT_EQ(CountedAllocations(), before);
  }
}

}  // namespace
}  // namespace warplut::generation
