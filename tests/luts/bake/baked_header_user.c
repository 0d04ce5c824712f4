/* Uses baked headers as C11 and as C++17: every row sums to 1. Ends with 0 if that holds. */
#include "baked/test_24.h"
#include "baked/test_i16.h"
#include "baked/test_i8.h"
#include "luts/baked/warplut_iir_x2.h"
#include "luts/table_file.h"

#ifdef __cplusplus
using namespace warplut::baked;
#endif

#define CHECK(name)                                                        \
  if (sizeof(name##Values) / sizeof(name##Values[0]) !=                    \
      (unsigned)name##Nodes * name##Nodes * name##Taps) {                  \
    return 1;                                                              \
  }                                                                        \
  for (int row = 0; row < name##Nodes * name##Nodes; ++row) {              \
    int sum = 0;                                                           \
    for (int k = 0; k < name##Taps; ++k) sum += name##Values[row * name##Taps + k]; \
    if (sum != 1 << name##FractionBits) return 1;                          \
  }

int main(void) {
  CHECK(kTestI16)
  CHECK(kTestI8)
  CHECK(kTest_24)
  CHECK(kWarplutIirX2)
  return kWarplutIirX2Pole < 0 && kWarplutIirX2Side > 0 && sizeof(struct WarplutTableFile) > 72 ? 0 : 1;
}
