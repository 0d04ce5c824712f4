// The entry of libFuzzer; WARPLUT_FUZZ_BODY is the body of the target.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  warplut::WARPLUT_FUZZ_BODY({reinterpret_cast<const char*>(data), size});
  return 0;
}
