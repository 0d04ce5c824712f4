// Questions that tests of kernels may ask their main function (kernel_main.cpp).
#pragma once

namespace warplut {

// Whether the test runs on the widest instruction set of this processor: once for each test. Long
// runs may be shorter on the others.
bool OnWidestInstructionSet();

}  // namespace warplut
