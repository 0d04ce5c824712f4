#include "tools/dense/dense_job.h"

#include "datasets/file.h"
#include "tools/scene_rendering.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/usage_error.h"

namespace warplut {

std::vector<DenseReport> JudgeScenes(const std::vector<std::string>& scenes,
                                     const DenseSettings& settings, const std::string& pictures) {
  std::vector<std::string> names;
  for (const std::string& selection : scenes) {
    for (const std::string& scene : AsUsage([&] { return SelectScenes(selection); })) {
      names.push_back(scene);
    }
  }
  if (!pictures.empty()) CreateFolder(pictures);
  std::vector<DenseReport> reports;
  {
    Progress progress("judging", static_cast<double>(names.size()), "scenes");
    for (const std::string& name : names) {
      ThrowIfInterrupted("dense", "nothing was printed");
      const DenseWorld world = SceneWorld(name, settings.world, settings.warm_up + settings.judged);
      reports.push_back(MeasureDense(name, world, settings, pictures));
      progress.Add(1);
    }
  }
  if (reports.size() > 1) reports.push_back(MeanDenseReport(reports));
  return reports;
}

}  // namespace warplut
