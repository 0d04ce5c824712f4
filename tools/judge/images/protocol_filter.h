// The filters that the protocols judge: the runtime's, and slow ones to compare with.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "runtime/warp.h"
#include "tools/judge/images/warp_protocol.h"

namespace warplut {

// A warp of images with any motion, as Warp.
using MotionWarp = std::function<void(const ImageView& history, const MotionView& motion,
                                      const MutableImageView& out)>;

// A filter that warps kR32F images with `warp` and the same motion everywhere.
ProtocolFilter UniformFilter(const std::string& name, const MotionWarp& warp);

// A filter that warps with the runtime's Warp in float, with these options (valid; a table outlives
// the filter). Where they have a prefilter, each warp runs it on its history first.
ProtocolFilter RuntimeFilter(const std::string& name, const WarpOptions& options);

// The options of a filter named on a command line, one of WarpNames(); nothing else has any.
std::optional<WarpOptions> NamedWarp(const std::string& name);

// What NamedWarp takes, for help and errors. A, K: decimal numbers or fractions such as 1/84.
std::string WarpNames();

// NamedWarp, or one of the six-tap filters of tools/judge/images/six_taps.h ("kaiser6:B",
// "lanczos3"), as a protocol takes it. An Error names what else was found.
ProtocolFilter NamedFilter(const std::string& name);

// "keys:-0.5800"
std::string KeysName(double a);

// "spline:0.0119"
std::string SplineName(double k);

}  // namespace warplut
