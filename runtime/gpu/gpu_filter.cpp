#include "runtime/gpu/gpu_filter.h"

#include "luts/filters.h"
#include "runtime/prefilter.h"
#include "runtime/warp/warp_kernels.h"

namespace warplut {
namespace {

constexpr int kLength = 64, kLines = 8;  // of shaders/prefilter.comp

int LayersOf(const WarpOptions& warp) {
  return FilterOf(warp) == Filter::kLut ? LayoutOf(warp.table->footprint()).count : 1;
}

PrefilterNumbers NumbersOf(const Prefilter& prefilter, int width, int height, bool along_x) {
  const bool recursive = prefilter.kind == PrefilterKind::kRecursive;
  return {.size = {width, height},
          .along_x = along_x ? 1 : 0,
          .reach = PrefilterReach(prefilter),
          .pole = recursive ? static_cast<float>(PoleOfSide(static_cast<double>(prefilter.side)))
                            : 0.0f,
          .padding = {},
          .taps = prefilter.taps};
}

}  // namespace

int AddTableImage(const WarpOptions& warp, GpuWorkspace& workspace) {
  const int nodes = FilterOf(warp) == Filter::kLut ? kTableNodes : 1;
  return workspace.AddImage({TexelFormat::kRgba32F, nodes, nodes, LayersOf(warp)});
}

// As luts/bake/table_texture.h.
std::vector<float> TableTexels(const WarpOptions& warp) {
  std::vector<float> texels;
  if (FilterOf(warp) != Filter::kLut) return texels;
  const Table& table = *warp.table;
  constexpr int kTexels = kTableNodes * kTableNodes;
  for (int layer = 0; layer < LayersOf(warp); ++layer) {
    for (int texel = 0; texel < kTexels; ++texel) {
      const float* row = table.data() + texel * RowFloats(table.footprint()) + layer * kGroupTaps;
      texels.insert(texels.end(), row, row + kGroupTaps);
    }
  }
  return texels;
}

float FilterParameterOf(const WarpOptions& warp) {
  return FilterOf(warp) == Filter::kCatmullRom ? static_cast<float>(kCatmullRomA)
                                               : ParameterOf(warp);
}

void AppendFilterConstants(const WarpOptions& warp, bool prefiltered,
                           std::vector<std::int32_t>* constants) {
  constants->push_back(static_cast<std::int32_t>(FilterOf(warp)));
  constants->push_back(static_cast<std::int32_t>(LookupOf(warp)));
  constants->push_back(prefiltered ? 1 : 0);
  constants->push_back(LayersOf(warp));
}

PrefilterPasses::PrefilterPasses(const Prefilter& prefilter, int width, int height,
                                 const std::vector<Images>& sets, GpuWorkspace& workspace) {
  if (!HasPrefilter(prefilter)) return;
  PassPlan plan = {.shader = Shader::kPrefilter,
                   .constants = {prefilter.kind == PrefilterKind::kRecursive ? 1 : 0},
                   .sets = {},
                   .numbers_bytes = sizeof(PrefilterNumbers),
                   .group_width = kLength,
                   .group_height = kLines};
  plan.name = "prefilter columns";
  plan.width = height;
  plan.height = width;
  for (const Images& images : sets)
    plan.sets.push_back({Stored(images.columns), Sampled(images.samples)});
  columns_ = workspace.AddPass(plan);
  plan.name = "prefilter rows";
  plan.width = width;
  plan.height = height;
  plan.sets.clear();
  for (const Images& images : sets)
    plan.sets.push_back({Stored(images.coefficients), Sampled(images.columns)});
  rows_ = workspace.AddPass(plan);
  along_y_ = NumbersOf(prefilter, width, height, false);
  along_x_ = NumbersOf(prefilter, width, height, true);
}

void PrefilterPasses::Record(std::size_t set, GpuWorkspace& workspace) const {
  workspace.Record(columns_, &along_y_, set);
  workspace.Record(rows_, &along_x_, set);
}

}  // namespace warplut
