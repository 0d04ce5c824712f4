// Sizes of memory as people write them.
#pragma once

#include <cstddef>
#include <string>

namespace warplut {

// "500M" is 500 * 2^20 bytes: a whole number of at least 1, and K, M or G for 2^10, 2^20, 2^30
// bytes. Empty: 0, which stands for no limit. An Error names anything else.
std::size_t ParseMemorySize(const std::string& text);

}  // namespace warplut
