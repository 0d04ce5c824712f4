#include "tools/judge/images/sr_cross.h"

#include "tools/judge/images/warp_protocol.h"
#include "train/fit/objective/prefilter_map.h"
#include "train/fit/objective/sr_objective.h"
#include "train/fit/random.h"
#include "train/fit/rivals/keys_search.h"
#include "train/fit/rollout/crops.h"

namespace warplut {
namespace {

constexpr int kPansPerCrop = 4;

CrossScore Judge(const Objective& objective, const Resampler& resampler) {
  CrossScore score;
  const std::vector<double> losses = objective.Losses(resampler);
  score.loss = objective.Value(losses);
  for (const double loss : losses) score.ssim.push_back(1 - loss);
  return score;
}

}  // namespace

Resampler TableResampler(const BakedTable& table) {
  const std::vector<IntegerRow> rows = TableIntegers(table.view(), "table");
  Resampler resampler;
  resampler.prefilter = ToReal(table.view().prefilter);
  resampler.footprint = table.view().footprint;
  for (int c = 0; c < kCanonicalNodes; ++c) {
    const auto [ix, jy] = CanonicalPosition(c);
    resampler.weights[c] = RealRow(rows[RowIndex(ix, jy)], table.format());
  }
  return resampler;
}

CrossColumn JudgeAtScale(const std::vector<CrossFilter>& filters, const std::vector<Image>& luma,
                         const TrainOptions& options) {
  CrossColumn column;
  column.options = options.Resolved();
  const TrainOptions& o = column.options;
  const SrObjective objective(
      DrawCrops(luma, o.crops, o.seed), o.horizons, DeriveSeed(o.seed, 1),
      {o.scale, *o.blend_a, *o.blend_b, *o.pan_share, kPansPerCrop, *o.aliasing});
  for (const Protocol& protocol : objective.protocols()) column.protocols.push_back(Name(protocol));
  column.keys_a = FitKeys(objective);
  column.keys = Judge(objective, KeysCanonicalWeights(column.keys_a));
  for (const CrossFilter& filter : filters) {
    column.scores.push_back(Judge(objective, filter.resampler));
  }
  return column;
}

}  // namespace warplut
