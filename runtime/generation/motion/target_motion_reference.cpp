#include "runtime/generation/motion/target_motion.h"
#include "runtime/motion_tiles.h"

namespace warplut::generation {

void TargetMotionRowReference(const GenerationJob& job, const Arrivals& arrivals, int y,
                              const MutableMotionView& from0, const MutableMotionView& from1,
                              std::uint8_t* disoccluded) {
  for (int x = 0; x < job.width(); ++x) {
    const TargetMotion motion = TargetMotionAt(job, arrivals, x, y);
    StoreMotion(job, motion, x, y, from0, from1, disoccluded);
  }
}

void OwnMotionRowReference(const GenerationJob& job, int y, const MutableMotionView& from0,
                           const MutableMotionView& from1) {
  for (int x = 0; x < job.width(); ++x) {
    const Vector displacement = MotionAt(from1, x, y);
    const bool moves = IsFinite(displacement);
    SetMotion(from1, x, y, moves ? displacement : Vector{});
    if (!job.Interpolates()) continue;
    SetMotion(from0, x, y, moves ? displacement + MotionAt(job.motion1, x, y) : Vector{});
  }
}

}  // namespace warplut::generation
