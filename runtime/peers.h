// Other systems that people would pick, as forms of SuperResolution and FrameGeneration: written
// anew from what was published about them, to be measured beside these. docs/METHODS.md tells what
// each has of its original and what not.
//
// SuperResolutionOptions::peer names one. It replaces the limit and the update of
// SuperResolution::Process by its own and warps the history by its own filter; planes, geometry and
// prediction are those of the options.
// FrameGenerationOptions::peer names one. It finds the motion of the generated frame in its own
// way; the warp and the blend are those of the options.
// A build without them says so in its PIPELINE.h (PipelineConfiguration::peers); a program that
// names none links none.
#pragma once

#include "luts/visibility.h"

namespace WARPLUT_PUBLIC warplut {

struct SrPeer;
struct GenerationPeer;

// Temporal upsampling: Yang, Liu and Salvi, A Survey of Temporal Antialiasing Techniques, Computer
// Graphics Forum 39(2), 2020; the variance box is Salvi's (GDC 2016).
extern const SrPeer kTaau;

// The two passes of Snapdragon Game Super Resolution 2: Qualcomm, 2024.
extern const SrPeer kSgsr2;

// FidelityFX Super Resolution 2: AMD, 2022.
extern const SrPeer kFsr2;

// A mesh of the pixels of frame 1, moved and drawn: Mark, McMillan and Bishop, Post-Rendering 3D
// Warping, I3D 1997.
extern const GenerationPeer kMeshWarp;

// Sources found by fixed-point iteration in both frames: Yang et al., Image-Based Bidirectional
// Scene Reprojection, SIGGRAPH Asia 2011.
extern const GenerationPeer kBidirectional;

// A mesh of one vertex for each tile, moved by the cameras and drawn: Qi, 144FPS Rendering on
// Mobile: Frame Prediction in Arena Breakout, SIGGRAPH 2024. DisplayedFrame::reprojection has the
// cameras; without them the vertices move by their motion.
extern const GenerationPeer kMeshProjection;

}  // namespace warplut
