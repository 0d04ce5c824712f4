// Rows of the benchmarks, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "tools/bench/generation_benchmark.h"
#include "tools/bench/pass_benchmark.h"
#include "tools/bench/sr_benchmark.h"
#include "tools/bench/ssim_benchmark.h"
#include "tools/bench/warp_benchmark.h"
#include "tools/tables/record_table.h"

namespace warplut {

// Sentences about the columns, and one line for each row.
std::string ToText(const WarpBenchmark& benchmark);
std::string ToText(const std::vector<SrBenchmarkRow>& rows);
std::string ToText(const std::vector<GenerationBenchmarkRow>& rows);
std::string ToText(const PassBenchmark& benchmark);
std::string ToText(const SsimBenchmark& benchmark);

// docs/JSON.md lists the keys.
Json ToJson(const WarpBenchmark& benchmark);
Json ToJson(const std::vector<SrBenchmarkRow>& rows);
Json ToJson(const std::vector<GenerationBenchmarkRow>& rows);
Json ToJson(const PassBenchmark& benchmark);
Json ToJson(const SsimBenchmark& benchmark);

}  // namespace warplut
