// How small a table of weights can be on given content: nodes, storage and lookup, against the
// error that they cause.
//
// The runtime looks weights up at kNodes nodes. A table of n = 8 or 16 is run as one of kNodes
// whose rows are what lookup in the table of n gives: for the bilinear lookup the same weights
// (up to 2^-22 where the storage is f32); for the nearest lookup offsets within 1 / 64 of the
// middle between two nodes take the farther of the two on one side. Tables of more than kNodes
// nodes are not run: they are larger than what the full pipeline has.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "luts/quantize/baked_table.h"
#include "luts/quantize/real_table.h"
#include "luts/table.h"
#include "tools/profile/profile_search.h"

namespace warplut {

inline constexpr int kSmallerNodes[] = {32, 16, 8};  // divisors of kNodes, the most first

struct SmallerTable {
  int nodes = kNodes;  // per axis
  TableFormat format = TableFormat::kI16;
  Lookup lookup = Lookup::kBilinear;
  std::size_t bytes = 0;  // all nodes
  std::optional<std::size_t>
      eighth_bytes;   // one node of each orbit of the symmetries, if the table has them
  PipelineCost cost;  // times are not measured

  std::size_t least_bytes() const { return eighth_bytes.value_or(bytes); }

  // Whether `warplut bake` makes it and the runtime reads it. One of fewer nodes is measured for
  // renderers that look weights up themselves.
  bool CanBeBaked() const { return nodes == kNodes; }
};

// Bytes of a table with n nodes per axis, and of its nodes (i, j) with 0 <= j <= i <= n / 2
// (n even), of which symmetry gives the others.
std::size_t TableBytes(int nodes, TableFormat format, Footprint footprint = Footprint::k16);
std::size_t EighthBytes(int nodes, TableFormat format, Footprint footprint = Footprint::k16);

// The stored table with all nodes, its last included.
RealTable ToRealTable(const TableView& view);

// Every (intervals / nodes)-th node, rounded to `format`, then all nodes that the runtime has by
// `lookup` in it: see above. `table` has kNodes intervals and kNodes is a multiple of `nodes`.
// Errors as RoundTable.
BakedTable RunnableTable(const RealTable& table, int nodes, TableFormat format, Lookup lookup);

// Runs `pipeline`, whose filter is a LUT, with every smaller table made from `table`, and compares
// with `full`. `step` is called before every one of them with the share that is done.
std::vector<SmallerTable> TrySmallerTables(PipelineMeter& meter, const ProfiledPipeline& pipeline,
                                           const RealTable& table,
                                           const std::vector<PipelineScore>& full,
                                           const std::function<void(double)>& step);

// Of those that can be baked the one with the fewest bytes whose loss is within the bound, for the
// lookup; of equals the one with the least loss. Null if none is.
const SmallerTable* SmallestWithin(const std::vector<SmallerTable>& tables, Lookup lookup,
                                   double within);

}  // namespace warplut
