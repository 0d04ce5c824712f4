// The tone mapping of linear HDR colour.
#pragma once

namespace warplut {

// The factor that tone-maps (r, g, b) >= 0 by its largest channel. Source: Karis, "Tone mapping",
// 2013.
inline float ToneMapFactor(float largest) { return 1 / (1 + largest); }

}  // namespace warplut
