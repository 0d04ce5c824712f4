// The calibrated numbers of the pipeline: one table for the pipeline, the calibration, the command
// line and the tests. Choices that are no numbers stand in the options of the methods.
#pragma once

#include <array>
#include <string>

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

struct Parameters {
  float sr_depth_threshold = 0.05f;         // T_D of super resolution
  float generation_depth_threshold = 0.3f;  // T_D of frame generation
  float brightness_threshold = 0.05f;       // T_B
  float blend_a = 0.85f;                    // a
  float blend_b = 0.9f;                     // b
  float clamp_gamma = 2.25f;                // half width of the colour box of super resolution
  // Of the peers (docs/METHODS.md), as published.
  float taau_blend = 0.1f;
  float taau_gamma = 1.0f;
  float sgsr2_weight = 1.0f / 3;
  float sgsr2_box = 20.0f;
  float fsr2_weight = 1.0f / 12;
  float fsr2_box = 20.0f;
  float fsr2_lock_ratio = 1.05f;
  float bidir_tolerance = 0.5f;
  // The slides of mesh projection have tiles of 8 to 16 pixels, and no thresholds: these are ours.
  float mesh_tile = 16.0f;
  float mesh_tensile = 4.0f;
  float mesh_shear = 0.25f;

  bool operator==(const Parameters&) const = default;

  // Whether every value lies in its range; otherwise *why (if not null) names the first one
  // outside, with its range.
  bool IsValid(std::string* why = nullptr) const;
};

struct ParameterInfo {
  const char* name;  // as in files and on the command line
  float Parameters::*member;
  float min, max;    // range of IsValid and of the search of calibration
  bool logarithmic;  // calibration moves in its logarithm (min > 0)
  const char* meaning;
};

inline constexpr std::array<ParameterInfo, 17> kParameters = {{
    {"sr_depth_threshold", &Parameters::sr_depth_threshold, 1e-4f, 4.0f, true,
     "history is rejected where depth differs by more, super resolution"},
    {"generation_depth_threshold", &Parameters::generation_depth_threshold, 1e-4f, 4.0f, true,
     "the farther frame was revealed where depth differs by more, frame generation"},
    {"brightness_threshold", &Parameters::brightness_threshold, 1e-3f, 1.0f, true,
     "the nearer frame is taken where luma differs by no more, interpolation"},
    {"blend_a", &Parameters::blend_a, 0.02f, 8.0f, true,
     "share of a sample that lies on the pixel centre, super resolution"},
    {"blend_b", &Parameters::blend_b, 0.0f, 4.0f, false,
     "how fast the share falls with the distance in render pixels, super resolution"},
    {"clamp_gamma", &Parameters::clamp_gamma, 0.25f, 16.0f, true,
     "half width of the variance box in standard deviations, super resolution"},
    {"taau_blend", &Parameters::taau_blend, 0.01f, 1.0f, true,
     "share of a sample that lies on the pixel centre, taau"},
    {"taau_gamma", &Parameters::taau_gamma, 0.25f, 16.0f, true,
     "half width of the variance box in standard deviations, taau"},
    {"sgsr2_weight", &Parameters::sgsr2_weight, 0.01f, 4.0f, true,
     "weight of the samples against that of the history, sgsr2"},
    {"sgsr2_box", &Parameters::sgsr2_box, 1.0f, 32.0f, true,
     "half width of the box where nothing moves, in standard deviations, sgsr2"},
    {"fsr2_weight", &Parameters::fsr2_weight, 0.01f, 4.0f, true,
     "weight of the samples against that of the history, fsr2"},
    {"fsr2_box", &Parameters::fsr2_box, 1.0f, 32.0f, true,
     "half width of the box where nothing moves, in standard deviations, fsr2"},
    {"fsr2_lock_ratio", &Parameters::fsr2_lock_ratio, 1.005f, 2.0f, true,
     "ratio of lumas up to which neighbours are alike, for the locks of fsr2"},
    {"bidir_tolerance", &Parameters::bidir_tolerance, 0.0625f, 8.0f, true,
     "pixels by which a source may miss the generated pixel, bidir"},
    {"mesh_tile", &Parameters::mesh_tile, 4.0f, 32.0f, true,
     "pixels of a side of a tile, rounded, mesh"},
    {"mesh_tensile", &Parameters::mesh_tensile, 1.0f, 64.0f, true,
     "pixels between foreground and background from which a vertex shows the latter, mesh"},
    {"mesh_shear", &Parameters::mesh_shear, 0.03125f, 64.0f, true,
     "pixels by which a source is off from which it is corrected, mesh"},
}};

// The index in kParameters of that name, or -1.
int FindParameter(const std::string& name);

// All names, with commas between.
std::string ParameterNames();

// The constants of the paper (Mob-FGSR, section 5). Its T_D is absolute, in units of the far plane.
// It has no variance box.
inline constexpr Parameters kPaperParameters = {.sr_depth_threshold = 0.0028f,
                                                .generation_depth_threshold = 0.0028f,
                                                .brightness_threshold = 0.13f,
                                                .blend_a = 0.34f,
                                                .blend_b = 0.81f,
                                                .clamp_gamma = 3.0f};

}  // namespace warplut
