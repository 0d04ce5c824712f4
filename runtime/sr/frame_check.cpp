#include "runtime/sr/frame_check.h"

#include <cmath>

#include "runtime/configuration/chosen.h"
#include "runtime/configuration/pipeline_check.h"
#include "runtime/core/image_check.h"
#include "runtime/peers/sr/sr_peer.h"

namespace warplut {
namespace {

// Whether the build contains what the options choose.
bool AreContained(const SuperResolutionOptions& o, std::string* why) {
  return CheckPart("super resolution", kPipeline.super_resolution, why) &&
         CheckPart("the reference versions of the passes", kPipeline.reference || !o.reference,
                   why) &&
         CheckPart("the peers of super resolution", kPipeline.peers || o.peer == nullptr, why) &&
         (o.peer == nullptr ||
          CheckChoice("The filter of the peer", kPipeline.filter, o.peer->filter, why)) &&
         CheckChoices(kSrChoices, kPipeline.sr, o, why);
}

// Whether the output is 1 to 4 times the render size, in one axis.
bool Fits(int render, int output) {
  return output >= render && output / 4.0 <= render && output <= kLargestSize;
}

}  // namespace

bool SuperResolutionOptions::IsValid(std::string* why) const {
  if (render_width < 1 || render_height < 1) {
    return Refuse({"The render size is ", SizeName(render_width, render_height),
                   "; at least 1 x 1 was expected."},
                  why);
  }
  if (!Fits(render_width, output_width) || !Fits(render_height, output_height)) {
    return Refuse({"The output size is ", SizeName(output_width, output_height),
                   "; 1 to 4 times the render size ", SizeName(render_width, render_height),
                   " was expected."},
                  why);
  }
  if (history_format == PixelFormat::kR32F) {
    return Refuse({"The history format is r32f; rgba8, rgba16f or rgba32f was expected."}, why);
  }
  if (!(coherent_share >= 0 && coherent_share <= 1)) {
    return Refuse({"The share of coherent residuals is ", std::to_string(coherent_share),
                   "; 0 to 1 was expected."},
                  why);
  }
  if (!(gate_width >= 0 && gate_width <= 1)) {
    return Refuse({"The gate width is ", std::to_string(gate_width), "; 0 to 1 was expected."},
                  why);
  }
  if (!AreContained(*this, why)) return false;
  if (peer != nullptr && (!WarpsHistory(*this) || HasResidual(*this))) {
    return Refuse({"The peer has no history that is warped, in the sample form; it needs one."},
                  why);
  }
  const char* reason = nullptr;
  if (WarpsHistory(*this) && !warp.IsValid(&reason)) {
    return Refuse({"The filter: ", reason, "."}, why);
  }
  return parameters.IsValid(why);
}

bool IsRenderSizeOf(const SuperResolutionOptions& o, int width, int height, int most_width,
                    int most_height, std::string* why) {
  const bool has_size = width >= 1 && height >= 1 && width <= most_width && height <= most_height;
  if (has_size && Fits(width, o.output_width) && Fits(height, o.output_height)) return true;
  const int least_width = (o.output_width + 3) / 4, least_height = (o.output_height + 3) / 4;
  return Refuse(
      {"The render size is ", SizeName(width, height), "; ", SizeName(least_width, least_height),
       " to ", SizeName(most_width, most_height), " was expected."},
      why);
}

bool IsFrameProcessable(const SuperResolutionOptions& options, const RenderedFrame& frame,
                        const MutableImageView& out, std::string* why) {
  const int width = options.render_width;
  const int height = options.render_height;
  if (!CheckColor("The colour", frame.color, width, height, why) ||
      !CheckChoice("The format of the colour", kPipeline.sr.color_format, frame.color.format,
                   why) ||
      !CheckColor("The output", out, options.output_width, options.output_height, why) ||
      !CheckChoice("The format of the output", kPipeline.sr.output_format, out.format, why)) {
    return false;
  }
  if (ReadsMotion(options) && (!CheckDepth("The depth", frame.depth, width, height, why) ||
                               !CheckMotion("The motion", frame.motion, width, height, why))) {
    return false;
  }
  if (frame.reactive.data != nullptr) {
    if (!options.reactive) {
      return Refuse({"The frame has a reactive mask, and the options say that none will come; "
                     "expected SuperResolutionOptions::reactive."},
                    why);
    }
    if (!CheckDepth("The reactive mask", frame.reactive, width, height, why)) return false;
  }
  if (!(std::abs(frame.jitter_x) <= 1 && std::abs(frame.jitter_y) <= 1)) {
    return Refuse({"The jitter is (", std::to_string(frame.jitter_x), ", ",
                   std::to_string(frame.jitter_y), "); -1 to 1 was expected."},
                  why);
  }
  return true;
}

}  // namespace warplut
