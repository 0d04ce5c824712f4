#include "runtime/generation/frame_check.h"

#include <cstdint>
#include <limits>

#include "runtime/configuration/pipeline_check.h"
#include "runtime/core/image_check.h"
#include "runtime/motion/point_carrier.h"
#include "runtime/motion_filter.h"
#include "runtime/peers/generation/generation_peer.h"

namespace warplut {
namespace {

// Whether the build contains what the options choose.
bool AreContained(const FrameGenerationOptions& o, std::string* why) {
  return CheckPart("frame generation", kContainsGeneration, why) &&
         CheckPart("the reference versions of the passes", kPipeline.reference || !o.reference,
                   why) &&
         CheckPart("the peers of frame generation", kPipeline.peers || o.peer == nullptr, why) &&
         CheckChoices(kGenerationChoices, kPipeline.generation, o, why);
}

// Whether the build takes colour of the formats.
bool CheckFormats(const DisplayedFrame& frame0, const DisplayedFrame& frame1,
                  const MutableImageView& out, std::string* why) {
  const auto& format = kPipeline.generation.color_format;
  return (frame0.color.data == nullptr ||
          CheckChoice("The format of frame 0", format, frame0.color.format, why)) &&
         CheckChoice("The format of frame 1", format, frame1.color.format, why) &&
         CheckChoice("The format of the output", kPipeline.generation.output_format, out.format,
                     why);
}

// Whether the peer takes what is known of the generated frame.
bool CheckReprojection(const FrameGenerationOptions& o, const Reprojection* known,
                       std::string* why) {
  if (known == nullptr || !Projects(o)) return true;
  if (!PointCarrier::Of(*known, o.width, o.height)) {
    if (!(known->depth_unit > 0)) {
      return Refuse({"depth_unit is ", std::to_string(known->depth_unit), "; expected above 0."},
                    why);
    }
    return known->source.IsValid(why) && known->generated.IsValid(why) &&
           Refuse({"The cameras lead nowhere; expected finite matrices of a usual scale."}, why);
  }
  return (known->moving.data == nullptr ||
          CheckDepth("The mask of what moves", known->moving, o.width, o.height, why)) &&
         (known->drawn.data == nullptr ||
          CheckColor("What is drawn anew", known->drawn, o.width, o.height, why));
}

}  // namespace

bool FrameGenerationOptions::IsValid(std::string* why) const {
  if (width < 1 || height < 1 || width > kLargestSize || height > kLargestSize) {
    return Refuse({"The frames are ", SizeName(width, height), "; expected 1 to ",
                   std::to_string(kLargestSize), " pixels in each axis."},
                  why);
  }
  if (std::int64_t{width} * height > std::numeric_limits<std::int32_t>::max()) {
    return Refuse({"The frames are ", SizeName(width, height), "; expected less than 2^31 pixels."},
                  why);
  }
  if (!(gate_width >= 0.0f && gate_width <= 1.0f)) {
    return Refuse({"gate_width is ", std::to_string(gate_width), "; expected 0 to 1."}, why);
  }
  if (motion_filter && !MotionFilterOptions{motion_filter_limit}.IsValid(why)) return false;
  if (!AreContained(*this, why)) return false;
  const char* reason = nullptr;
  if (!warp.IsValid(&reason)) return Refuse({"Warp: ", reason, "."}, why);
  return parameters.IsValid(why);
}

bool AreGenerable(const FrameGenerationOptions& o, const DisplayedFrame& frame0,
                  const DisplayedFrame& frame1, float alpha, const MutableImageView& out,
                  std::string* why) {
  if (!(alpha > 0.0f && alpha < 1.0f)) {
    return Refuse({"alpha is ", std::to_string(alpha), "; expected it between 0 and 1."}, why);
  }
  if (frame0.color.data != nullptr &&
      !CheckColor("The colour of frame 0", frame0.color, o.width, o.height, why)) {
    return false;
  }
  const auto fits = [&](const char* name, const ImageView& hud) {
    return hud.data == nullptr || CheckColor(name, hud, o.width, o.height, why);
  };
  if (!fits("The HUD of frame 0", frame0.hud) || !fits("The HUD of frame 1", frame1.hud)) {
    return false;
  }
  return CheckDepth("The depth of frame 0", frame0.depth, o.width, o.height, why) &&
         CheckMotion("The motion of frame 0", frame0.motion, o.width, o.height, why) &&
         CheckColor("The colour of frame 1", frame1.color, o.width, o.height, why) &&
         CheckDepth("The depth of frame 1", frame1.depth, o.width, o.height, why) &&
         CheckMotion("The motion of frame 1", frame1.motion, o.width, o.height, why) &&
         CheckColor("The output", out, o.width, o.height, why) &&
         CheckFormats(frame0, frame1, out, why) && CheckReprojection(o, frame1.reprojection, why);
}

}  // namespace warplut
