// Luma: the grey value of a colour.
#pragma once

namespace warplut {

// Weights of R, G, B. Source: ITU-R BT.709-6, section 3.
inline constexpr double kLumaWeights[3] = {0.2126, 0.7152, 0.0722};

}  // namespace warplut
