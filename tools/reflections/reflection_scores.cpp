#include "tools/reflections/reflection_scores.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <functional>
#include <memory>

#include "runtime/peers/rays/depth_pyramid.h"
#include "runtime/peers/rays/screen_mesh.h"

namespace warplut {
namespace {

using peers::ScreenHit;
using peers::ScreenRay;

struct TracedRay {
  ScreenRay ray;
  bool is_findable;
  Vec2 position;
};

struct Tracer {
  std::string name;
  std::function<ScreenHit(const ScreenRay&, double thickness)> trace;
};

std::vector<Tracer> TracersOf(const ImageView& depth, const ReflectionSettings& settings) {
  const auto pyramid = std::make_shared<const peers::DepthPyramid>(depth);
  const auto march = [pyramid](int top) {
    return [pyramid, top](const ScreenRay& ray, double thickness) {
      return pyramid->March(ray, thickness, top);
    };
  };
  std::vector<Tracer> tracers = {{"pixels", march(0)}, {"mip-maps", march(pyramid->top())}};
  for (const int tile : settings.tiles) {
    const auto mesh = std::make_shared<const peers::ScreenMesh>(
        depth, peers::ScreenMeshOptions{.tile = tile, .tear = settings.tear});
    tracers.push_back(
        {"mesh " + std::to_string(tile),
         [mesh](const ScreenRay& ray, double thickness) { return mesh->Trace(ray, thickness); }});
  }
  return tracers;
}

ReflectionScores Score(const Tracer& tracer, double thickness, double within,
                       const std::vector<TracedRay>& rays) {
  double found = 0, misplaced = 0, false_hits = 0, findable = 0, cells = 0, triangles = 0;
  for (const TracedRay& traced : rays) {
    const ScreenHit hit = tracer.trace(traced.ray, thickness);
    cells += hit.cells;
    triangles += hit.triangles;
    findable += traced.is_findable ? 1 : 0;
    if (!hit.is_hit) continue;
    const bool is_near = std::hypot(hit.x - traced.position.x, hit.y - traced.position.y) <= within;
    (!traced.is_findable ? false_hits : is_near ? found : misplaced) += 1;
  }
  const auto count = static_cast<double>(rays.size());
  return {tracer.name,
          thickness,
          found / findable,
          misplaced / findable,
          false_hits / (count - findable),
          cells / count,
          triangles / count};
}

// The mean of the values that are numbers.
double MeanOf(const std::vector<double>& values) {
  double sum = 0, count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    count += 1;
  }
  return sum / count;
}

}  // namespace

bool ReflectionSettings::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& sentence) {
    if (why != nullptr) *why = sentence;
    return false;
  };
  RenderOptions options;
  options.width = width;
  options.height = height;
  if (!options.IsValid(why)) return false;
  if (frame < 0 || frame >= 100000) {
    return fail("The frame is " + std::to_string(frame) + "; expected 0 to 99999.");
  }
  if (step < 1 || step > 256) {
    return fail("The step is " + std::to_string(step) + "; expected 1 to 256 pixels.");
  }
  if (!(within > 0 && std::isfinite(within))) {
    return fail("The distance is " + std::to_string(within) +
                " pixels; expected a finite number above 0.");
  }
  for (const double thickness : thicknesses) {
    if (thickness >= 0) continue;
    return fail("A thickness is " + std::to_string(thickness) + "; expected at least 0.");
  }
  if (thicknesses.empty() || tiles.empty()) {
    return fail("There is no thickness or no tile; expected at least one of each.");
  }
  for (const int tile : tiles) {
    if (!peers::ScreenMeshOptions{.tile = tile, .tear = tear}.IsValid(why)) return false;
  }
  return true;
}

ReflectionReport ScoreReflections(const std::string& scene, const ImageView& depth,
                                  const peers::Pinhole& pinhole,
                                  const std::vector<SceneReflection>& reflections,
                                  const ReflectionSettings& settings) {
  std::vector<TracedRay> rays;
  double findable = 0;
  for (const SceneReflection& reflection : reflections) {
    if (!reflection.is_surface) continue;
    rays.push_back(
        {ScreenRay::Of(pinhole, reflection.origin, reflection.direction, depth.width, depth.height),
         reflection.is_visible, reflection.position});
    findable += reflection.is_visible ? 1 : 0;
  }
  const std::vector<Tracer> tracers = TracersOf(depth, settings);
  const std::size_t thicknesses = settings.thicknesses.size();
  ReflectionReport report{scene, static_cast<double>(rays.size()),
                          findable / static_cast<double>(rays.size()),
                          std::vector<ReflectionScores>(tracers.size() * thicknesses)};
  oneapi::tbb::parallel_for(std::size_t{0}, report.methods.size(), [&](std::size_t i) {
    report.methods[i] = Score(tracers[i / thicknesses], settings.thicknesses[i % thicknesses],
                              settings.within, rays);
  });
  return report;
}

ReflectionReport MeanReflections(const std::vector<ReflectionReport>& reports) {
  ReflectionReport mean = reports.front();
  mean.scene = "mean";
  const auto over = [&](const auto& value) {
    std::vector<double> values;
    for (const ReflectionReport& report : reports) values.push_back(value(report));
    return MeanOf(values);
  };
  mean.rays = over([](const ReflectionReport& report) { return report.rays; });
  mean.findable = over([](const ReflectionReport& report) { return report.findable; });
  for (std::size_t i = 0; i < mean.methods.size(); ++i) {
    for (double ReflectionScores::*score :
         {&ReflectionScores::found, &ReflectionScores::misplaced, &ReflectionScores::false_hits,
          &ReflectionScores::cells, &ReflectionScores::triangles}) {
      mean.methods[i].*score =
          over([&](const ReflectionReport& report) { return report.methods[i].*score; });
    }
  }
  return mean;
}

}  // namespace warplut
