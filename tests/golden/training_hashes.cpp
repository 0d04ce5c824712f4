#include <fmt/format.h>

#include "datasets/hash.h"
#include "runtime/warp.h"
#include "tests/golden/golden_hashes.h"
#include "train/fit/rollout/noise_image.h"
#include "train/fit/trainer.h"

namespace warplut {

GoldenHashes TrainingHashes() {
  std::vector<TrainImage> images(2);
  for (std::size_t i = 0; i < images.size(); ++i) {
    FitData& record = images[i].record;
    record = {fmt::format("noise{}.png", i), fmt::format("{:040}", i), 160, 140};
    images[i].image = NoiseImage(record.width, record.height, i);
  }
  GoldenHashes hashes;
  for (const TrainObjective objective : {TrainObjective::kWarp, TrainObjective::kSr}) {
    TrainOptions options;
    options.horizons = {2, 6};
    options.crops = 4;
    options.stages = 2;
    options.iterations = 3;
    options.objective = objective;
    const Fit fit = Train(options, images).fit;
    const auto* bytes = reinterpret_cast<const char*>(fit.parameters.data());
    hashes[fmt::format("training/{}/{}", fit.objective, WarpTarget())] =
        Sha1({bytes, sizeof(double) * fit.parameters.size()});
  }
  return hashes;
}

}  // namespace warplut
