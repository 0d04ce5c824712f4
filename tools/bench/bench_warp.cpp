// Prints the warp benchmark; exits with 3 if a target is missed.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "tools/bench/warp_benchmark.h"

int main() {
  try {
    const warplut::WarpBenchmark benchmark = warplut::RunWarpBenchmark({});
    std::fputs(warplut::FormatTable(benchmark).c_str(), stdout);
    const bool met = std::all_of(benchmark.rows.begin(), benchmark.rows.end(),
                                 [](const warplut::WarpBenchmarkRow& row) { return row.met(); });
    return met ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_warp: %s\n", error.what());
    return 2;
  }
}
