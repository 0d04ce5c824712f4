#include "runtime/float_environment.h"

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

// No computation may move across a change of the environment; compilers do not know that it
// matters. Callers see a call of another file, whose memory may have changed.
namespace warplut {
namespace {

#if defined(__SSE__) || defined(_M_X64)

constexpr std::uint32_t kFlags = 0x3F;  // of exceptions that were raised
// All exceptions masked, to nearest; results (bit 15) and operands (bit 6) are flushed.
constexpr std::uint32_t kControl = 0x1F80 | 1u << 15 | 1u << 6;

std::uint64_t Get() { return _mm_getcsr(); }
void Set(std::uint64_t value) { _mm_setcsr(static_cast<std::uint32_t>(value)); }
bool IsSet(std::uint64_t value) { return (value & ~std::uint64_t{kFlags}) == kControl; }

#elif defined(__aarch64__)

// FPCR is the upper half, FPSR, of the flags, the lower one. No traps, to nearest, NaNs keep their
// bits; FZ (bit 24) flushes operands and results but halves.
constexpr std::uint64_t kControl = std::uint64_t{1u << 24} << 32;

std::uint64_t Get() {
  std::uint64_t control, status;
  asm volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(control), "=r"(status) : : "memory");
  return control << 32 | status;
}
void Set(std::uint64_t value) {
  asm volatile("msr fpcr, %0\n\tmsr fpsr, %1"
               :
               : "r"(value >> 32), "r"(value & 0xFFFFFFFFu)
               : "memory");
}
bool IsSet(std::uint64_t value) { return value >> 32 == kControl >> 32; }

#else

constexpr std::uint64_t kControl = 0;

std::uint64_t Get() { return 0; }
void Set(std::uint64_t) {}
bool IsSet(std::uint64_t) { return true; }

#endif

}  // namespace

FloatEnvironment::FloatEnvironment() : caller_(Get()) {
  if (!IsSet(caller_)) Set(kControl);
}

FloatEnvironment::~FloatEnvironment() { Set(caller_); }

}  // namespace warplut
