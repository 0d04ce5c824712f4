// What the peers of frame generation share: uniform motion, and how a source is ruled out.
#pragma once

#include "runtime/generation/generation_job.h"
#include "runtime/warp.h"

namespace warplut::peers {

using namespace generation;

// A motion whose source lies outside of every image: the blend takes the other frame.
inline constexpr float kOutside = 2.0f * kLargestSize;

// The motion from frame 0 to time alpha is this share of that from frame 1.
constexpr float BackwardShare(float alpha) { return -alpha / (1 - alpha); }

}  // namespace warplut::peers
