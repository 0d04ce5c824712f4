// Prints constants.glsl: the numbers and enumerators of the C++ headers, for the shaders.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include "luts/filters.h"
#include "luts/table.h"
#include "luts/tap_layout.h"
#include "runtime/choices.h"
#include "runtime/color_encoding.h"
#include "runtime/filter.h"
#include "runtime/generation/blend.h"
#include "runtime/generation/motion/surface_before.h"
#include "runtime/generation/motion/target_motion.h"
#include "runtime/motion/camera_rounds.h"
#include "runtime/motion/motion_split.h"
#include "runtime/prefilter.h"
#include "runtime/sr/aliasing.h"
#include "runtime/sr/reference.h"

namespace warplut {
namespace {

void Print(const char* name, float value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.9g", static_cast<double>(value));
  const bool is_whole = std::string(number).find_first_of(".e") == std::string::npos;
  std::printf("const float %s = %s%s;\n", name, number, is_whole ? ".0" : "");
}
void Print(const char* name, int value) { std::printf("const int %s = %d;\n", name, value); }
void Print(const char* name, std::uint32_t value) {
  std::printf("const uint %s = 0x%Xu;\n", name, value);
}
void Print(const char* name, const float (&v)[3]) {
  std::printf("const vec3 %s = vec3(%.9g, %.9g, %.9g);\n", name, static_cast<double>(v[0]),
              static_cast<double>(v[1]), static_cast<double>(v[2]));
}
template <class Enum>
void PrintEnum(const char* name, Enum value) {
  Print(name, static_cast<int>(value));
}

void PrintTaps(const char* name, Footprint footprint) {
  const TapLayout& layout = LayoutOf(footprint);
  const int taps = TapCount(footprint);
  std::printf("const ivec2 %s[%d] = ivec2[%d](", name, taps, taps);
  for (int place = 0; place < taps; ++place) {
    const int k = layout.Weight(place);
    std::printf("%sivec2(%d, %d)", place > 0 ? ", " : "", TapX(k), TapY(k));
  }
  std::printf(");\n");
}

void PrintAll() {
  std::printf("// Written by shader_constants from the C++ headers.\n");
  PrintEnum("kHistoryFormSample", HistoryForm::kSample);
  PrintEnum("kHistoryFormResidual", HistoryForm::kResidual);
  PrintEnum("kHistoryFormAdaptive", HistoryForm::kAdaptive);
  PrintEnum("kColorClampNone", ColorClamp::kNone);
  PrintEnum("kColorClampBox", ColorClamp::kBox);
  PrintEnum("kColorClampVariance", ColorClamp::kVariance);
  PrintEnum("kDepthMeasureNone", DepthMeasure::kNone);
  PrintEnum("kDepthMeasureAbsolute", DepthMeasure::kAbsolute);
  PrintEnum("kDepthMeasureRelative", DepthMeasure::kRelative);
  PrintEnum("kMotionUpsamplingNearest", MotionUpsampling::kNearest);
  PrintEnum("kMotionUpsamplingDilated", MotionUpsampling::kDilated);
  PrintEnum("kMotionUpsamplingEdgeAware", MotionUpsampling::kEdgeAware);
  PrintEnum("kMotionUpsamplingStatic", MotionUpsampling::kStatic);
  PrintEnum("kCurrentFrameBilinear", CurrentFrame::kBilinear);
  PrintEnum("kCurrentFrameBicubic", CurrentFrame::kBicubic);
  PrintEnum("kColorEncodingDisplay", ColorEncoding::kDisplay);
  PrintEnum("kColorEncodingLinearHdr", ColorEncoding::kLinearHdr);
  PrintEnum("kMotionModelLinear", MotionModel::kLinear);
  PrintEnum("kMotionModelQuadratic", MotionModel::kQuadratic);
  PrintEnum("kMotionModelPerspective", MotionModel::kPerspective);
  PrintEnum("kDisocclusionFillOwnMotion", DisocclusionFill::kOwnMotion);
  PrintEnum("kDisocclusionFillBackground", DisocclusionFill::kBackground);
  PrintEnum("kDisocclusionFillNone", DisocclusionFill::kNone);
  PrintEnum("kFilterBilinear", Filter::kBilinear);
  PrintEnum("kFilterCatmullRom", Filter::kCatmullRom);
  PrintEnum("kFilterKeys", Filter::kKeys);
  PrintEnum("kFilterLut", Filter::kLut);
  PrintEnum("kFilterSpline", Filter::kSpline);
  PrintEnum("kLookupNearest", Lookup::kNearest);
  PrintEnum("kLookupBilinear", Lookup::kBilinear);

  Print("kNodes", kNodes);
  PrintTaps("kTaps24", Footprint::k24);
  PrintTaps("kTaps36", Footprint::k36);
  Print("kFirstWindowTap", kFirstWindowTap);
  Print("kFirstSampledTexel", kFirstSampledTexel);
  Print("kFarthestTexel", kFarthestTexel);
  Print("kCatmullRomA", static_cast<float>(kCatmullRomA));
  Print("kLargestPrefilterReach", kLargestPrefilterReach);
  Print("kLargestFirReach", kLargestFirReach);
  Print("kLargestPrefiltered", kLargestPrefiltered);

  Print("kFarthestDepth", kFarthestDepth);
  Print("kNoMotion", kFarthestDepth);
  Print("kSurfaceStep", kSurfaceStep);
  Print("kBoxMiddle", kBoxMiddle);
  Print("kBoxSide", kBoxSide);
  Print("kSmoothShare", kSmoothShare);
  Print("kLeastAliasing", kLeastAliasing);
  Print("kMostAliasing", kMostAliasing);
  Print("kAliasingTile", kAliasingTile);

  Print("kCameraUnknowns", kCameraUnknowns);
  Print("kCameraSamples", kCameraSamples);
  Print("kLeastSamples", CameraFit::kLeastSamples);
  Print("kCameraRounds", kCameraRounds);
  Print("kHalvingRounds", kHalvingRounds);
  Print("kLeastCut", static_cast<float>(kLeastCut));
  Print("kNearMedians", static_cast<float>(kNearMedians));
  Print("kNoiseToLimit", static_cast<float>(kNoiseToLimit));
  Print("kLeastDepth", kLeastDepth);

  Print("kNanBits", std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN()));
  Print("kNoArrival", generation::SplatSource(generation::kNoSplat));
  Print("kNoArrivalDepth", generation::kNoArrivalDepth);
  Print("kBackgroundReach", generation::kBackgroundReach);
  Print("kSearchSteps", generation::kSearchSteps);
  Print("kSearchClosure", generation::kSearchClosure);
  Print("kSurfaceTolerance", generation::kSurfaceTolerance);
  Print("kLeastSurfaceDepth", generation::kLeastSurfaceDepth);
  Print("kLeastDepthRatio", generation::kLeastDepthRatio);
  Print("kBrightnessWeights", generation::kBrightnessWeights);
  Print("kUnlike", generation::kUnlike);

  Print("kHdrOctaves", kHdrOctaves);
  Print("kHdrGain", kHdrGain);
  Print("kLargestHdr", kLargestHdr);
  Print("kMantissaBits", kMantissaBits);
  Print("kOneBits", kOneBits);
  Print("kUnlimitedCode", HdrCode(kUnlimitedHdr));
}

}  // namespace
}  // namespace warplut

int main() {
  warplut::PrintAll();
  return std::ferror(stdout) == 0 ? 0 : 1;
}
