// Numbers to test a port of a table against.
#pragma once

#include <string>

#include "luts/table.h"

namespace warplut {

// The text of NAME.test.json: for offsets that are nodes, between nodes and at random, the weights
// of both lookups and a warped value. docs/FORMATS.md. The same table gives the same bytes.
std::string TestVectors(const std::string& name, const Table& table);

}  // namespace warplut
