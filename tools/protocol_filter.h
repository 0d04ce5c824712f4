// The runtime's filters, as the protocols take them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "runtime/warp.h"
#include "tools/warp_protocol.h"

namespace warplut {

// A warp of images with any motion, as Warp.
using MotionWarp = std::function<void(const ImageView& history, const MotionView& motion,
                                      const MutableImageView& out)>;

// A filter that warps kR32F images with `warp` and the same motion everywhere.
ProtocolFilter UniformFilter(const std::string& name, const MotionWarp& warp);

// A filter that warps with the runtime's Warp in float, with these options (valid; a table outlives the filter).
ProtocolFilter RuntimeFilter(const std::string& name, const WarpOptions& options);

// The options of a filter named on a command line: "bilinear", "catmull-rom" or "keys:A" with A in [-1, 0]; nothing else has any.
std::optional<WarpOptions> NamedWarp(const std::string& name);

// NamedWarp as a protocol takes it. An Error names what else was found.
ProtocolFilter NamedFilter(const std::string& name);

// "keys:-0.5800"
std::string KeysName(double a);

}  // namespace warplut
