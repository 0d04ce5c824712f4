// Counts what a test program takes from the heap: linking counted_allocations.cpp replaces operator
// new and delete.
#pragma once

namespace warplut {

// Calls of operator new, aligned or not, by any thread since the program started.
int CountedAllocations();

}  // namespace warplut
