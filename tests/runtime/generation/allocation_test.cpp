// Counts what is allocated while frames are generated.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/runtime/generation/generation_fixture.h"

namespace {

std::atomic<int> allocations = 0;

void* Allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return Allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

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
    const int before = allocations;
    generation.Interpolate(frame0.view(), frame1.view(), 0.5f, out.view());
    generation.Extrapolate(frame0.view(), frame1.view(), 0.5f, out.view());
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace warplut::generation
