#include "runtime/gpu/input_conventions.h"

namespace warplut {

InputConventions InputConventions::DepthBuffer(float near_plane, float far_plane, bool reversed) {
  const float ratio = far_plane / near_plane;
  InputConventions conventions;
  conventions.depth_buffer = true;
  conventions.depth_a = reversed ? 1.0f : ratio;
  conventions.depth_b = reversed ? ratio - 1 : 1 - ratio;
  return conventions;
}

}  // namespace warplut
