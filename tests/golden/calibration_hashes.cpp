#include <hwy/highway.h>

#include "datasets/hash.h"
#include "runtime/warp.h"
#include "tests/golden/golden_hashes.h"
#include "tests/golden/golden_scene.h"
#include "train/calibration/calibration.h"
#include "train/calibration/clip_loss.h"

namespace warplut {
namespace {

constexpr int kFrames = 6;

void Append(const Candidate& candidate, std::string& bytes) {
  for (const ParameterInfo& info : kParameters) {
    const float value = candidate.parameters.*info.member;
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  bytes.append(reinterpret_cast<const char*>(&candidate.loss), sizeof candidate.loss);
}

}  // namespace

GoldenHashes CalibrationHashes() {
  const auto clip = std::make_shared<const Clip>(GoldenClip(kFrames));
  GoldenHashes hashes;
  // Processors with wider vectors have this set too.
  if ((hwy::SupportedTargets() & HWY_AVX2) != 0) hwy::SetSupportedTargetsForTest(HWY_AVX2);
  for (const char* mode : {"sr", "i"}) {
    ClipRun run{.clip = clip, .options = {}};
    run.options.method = FindMethod(mode);
    run.options.every = run.options.method->generation == Generation::kNone ? 1 : 2;
    run.options.super_resolution.warp =
        run.options.generation.warp = {.filter = Filter::kCatmullRom};
    SerialExecutor executor;
    ClipLoss loss({run}, executor);
    CalibrationOptions options;
    options.fitted = ParametersOf({run.options.method});
    options.random_starts = 0;
    const CalibrationResult result = Calibrate(options, loss);
    std::string bytes;
    Append(result.best, bytes);
    Append(result.kept, bytes);
    hashes[std::string("calibration/") + mode + "/" + WarpTarget()] = Sha1(bytes);
  }
  hwy::SetSupportedTargetsForTest(0);
  return hashes;
}

}  // namespace warplut
