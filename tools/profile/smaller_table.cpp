#include "tools/profile/smaller_table.h"

#include <cmath>
#include <tuple>

#include "luts/quantize/quantize.h"
#include "tools/table_format.h"

namespace warplut {
namespace {

// Every k-th node.
RealTable Subsample(const RealTable& table, int nodes) {
  RealTable coarse{.name = table.name,
                   .intervals = nodes,
                   .rows = {},
                   .prefilter = table.prefilter,
                   .footprint = table.footprint};
  const int step = table.intervals / nodes;
  for (int j = 0; j <= nodes; ++j) {
    for (int i = 0; i <= nodes; ++i) coarse.rows.push_back(table.Row(i * step, j * step));
  }
  return coarse;
}

// The table as `format` stores it.
RealTable Rounded(RealTable table, TableFormat format) {
  const std::vector<IntegerRow> rows = RoundTable(table, format);
  for (std::size_t i = 0; i < rows.size(); ++i) table.rows[i] = RealRow(rows[i], format);
  return table;
}

Weights<double> LookUp(const RealTable& table, double dx, double dy, Lookup lookup) {
  const double x = dx * table.intervals, y = dy * table.intervals;
  if (lookup == Lookup::kNearest) {
    return table.Row(static_cast<int>(x + 0.5), static_cast<int>(y + 0.5));
  }
  const int i = std::min(static_cast<int>(x), table.intervals - 1);
  const int j = std::min(static_cast<int>(y), table.intervals - 1);
  const double fx = x - i, fy = y - j;
  Weights<double> w{};
  for (int k = 0; k < kWeights; ++k) {
    const auto n = static_cast<std::size_t>(k);
    w[n] = (1 - fy) * ((1 - fx) * table.Row(i, j)[n] + fx * table.Row(i + 1, j)[n]) +
           fy * ((1 - fx) * table.Row(i, j + 1)[n] + fx * table.Row(i + 1, j + 1)[n]);
  }
  return w;
}

}  // namespace

std::size_t TableBytes(int nodes, TableFormat format, Footprint footprint) {
  return static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes) *
         static_cast<std::size_t>(TapCount(footprint)) * BytesPerWeight(format);
}

std::size_t EighthBytes(int nodes, TableFormat format, Footprint footprint) {
  const auto side = static_cast<std::size_t>(nodes / 2 + 1);
  return side * (side + 1) / 2 * static_cast<std::size_t>(TapCount(footprint)) *
         BytesPerWeight(format);
}

RealTable ToRealTable(const TableView& view) {
  const Table table(view);
  RealTable real = SampleWeights("table", kNodes, [&](double dx, double dy) {
    const Weights<float> node =
        table.At(static_cast<float>(dx), static_cast<float>(dy), Lookup::kNearest);
    Weights<double> weights;
    std::copy(node.begin(), node.end(), weights.begin());
    return weights;
  });
  real.prefilter = view.prefilter;
  real.footprint = view.footprint;
  return real;
}

BakedTable RunnableTable(const RealTable& table, int nodes, TableFormat format, Lookup lookup) {
  const RealTable stored = Rounded(Subsample(table, nodes), format);
  if (nodes == kNodes) return Quantize(stored, format);
  const RealTable runnable = SampleWeights(
      stored.name, kNodes, [&](double dx, double dy) { return LookUp(stored, dx, dy, lookup); });
  // f32 holds the products of the other storages and sixteenths exactly.
  std::vector<IntegerRow> rows;
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      Weights<double> w = runnable.Row(i, j);
      IntegerRow& row = rows.emplace_back();
      std::int32_t rest = std::int32_t{1} << FractionBits(TableFormat::kF32);
      for (std::size_t k = 0; k < w.size(); ++k) {
        row[k] = static_cast<std::int32_t>(
            std::lround(std::ldexp(w[k], FractionBits(TableFormat::kF32))));
        rest -= row[k];
      }
      row[kIdentityWeight] += rest;
    }
  }
  return BakedTable(TableFormat::kF32, rows, table.prefilter, table.footprint);
}

std::vector<SmallerTable> TrySmallerTables(PipelineMeter& meter, const ProfiledPipeline& pipeline,
                                           const RealTable& table,
                                           const std::vector<PipelineScore>& full,
                                           const std::function<void(double)>& step) {
  const bool symmetric = Asymmetry(table) <= kSymmetryTolerance;
  std::vector<SmallerTable> tables;
  for (const int nodes : kSmallerNodes) {
    for (const TableFormat format : kTableFormats) {
      for (const Lookup lookup : {Lookup::kNearest, Lookup::kBilinear}) {
        SmallerTable& smaller = tables.emplace_back();
        smaller.nodes = nodes;
        smaller.format = format;
        smaller.lookup = lookup;
        smaller.bytes = TableBytes(nodes, format, table.footprint);
        if (symmetric) smaller.eighth_bytes = EighthBytes(nodes, format, table.footprint);
      }
    }
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    step(static_cast<double>(i) / static_cast<double>(tables.size()));
    SmallerTable& smaller = tables[i];
    const BakedTable baked = RunnableTable(table, smaller.nodes, smaller.format, smaller.lookup);
    const Table runnable(baked.view());
    ProfiledPipeline with = pipeline;
    with.SetWarp({.filter = Filter::kLut, .table = &runnable, .lookup = smaller.lookup});
    smaller.cost = CostOf(meter.Judge(with), full);
  }
  return tables;
}

const SmallerTable* SmallestWithin(const std::vector<SmallerTable>& tables, Lookup lookup,
                                   double within) {
  const SmallerTable* best = nullptr;
  for (const SmallerTable& table : tables) {
    if (!table.CanBeBaked() || table.lookup != lookup || !(table.cost.loss <= within)) continue;
    if (best == nullptr || std::tuple(table.least_bytes(), table.cost.loss) <
                               std::tuple(best->least_bytes(), best->cost.loss)) {
      best = &table;
    }
  }
  return best;
}

}  // namespace warplut
