// Screen-space reflections by mip-maps and by the mesh, against where the reflected rays really go.
#pragma once

#include <string>
#include <vector>

#include "datasets/scenes/scene_renderer.h"
#include "runtime/image_view.h"
#include "runtime/peers/rays/screen_ray.h"
#include "tools/reflections/reflection_settings.h"

namespace warplut {

// One way to trace rays, with one thickness. A ray is *findable* if it hits what the camera sees,
// from the same side.
struct ReflectionScores {
  std::string method;     // pixels, mip-maps, or mesh and the tile
  double thickness = 0;   // of surfaces, as a share of their depth
  double found = 0;       // of findable rays: hits within `within` pixels of the true position
  double misplaced = 0;   // of findable rays: hits elsewhere
  double false_hits = 0;  // of all other rays: hits
  double cells = 0;       // mean per ray: pixels, texels or tiles
  double triangles = 0;   // mean per ray
};

struct ReflectionReport {
  std::string scene;
  double rays = 0;      // that begin on a surface
  double findable = 0;  // share of them
  std::vector<ReflectionScores> methods;
};

// Traces the reflections that are rays. `depth` is R32F, view depth in the unit of the reflections,
// infinite where the sky is. Without findable rays their shares are NaN, and so on. Threads do not
// change the numbers.
ReflectionReport ScoreReflections(const std::string& scene, const ImageView& depth,
                                  const peers::Pinhole& pinhole,
                                  const std::vector<SceneReflection>& reflections,
                                  const ReflectionSettings& settings);

// The means over reports of the same methods, under the name "mean". Shares that a scene lacks have
// no part.
ReflectionReport MeanReflections(const std::vector<ReflectionReport>& reports);

}  // namespace warplut
