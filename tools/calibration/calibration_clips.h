// The clips that a calibration runs on, as the sequences and the options divide them.
#pragma once

#include <string>
#include <vector>

#include "tools/calibration/calibration_request.h"
#include "train/calibration/clip_loss.h"

namespace warplut {

// A clip's part in the calibration.
struct CalibrationPart {
  Sequence sequence;
  FrameRange range;
  bool held_out = false;
};

// One part for each sequence, or two halves. UsageError: a name to hold out that no sequence has,
// nothing left to fit. Error: two sequences of one name, or as ReadSequenceFor and ParseFrames.
std::vector<CalibrationPart> CalibrationParts(const CalibrationRequest& request,
                                              const Pipeline& pipeline,
                                              const std::vector<const MethodInfo*>& methods);

// The parts' runs, apart: those that are fitted and those that are held out.
struct CalibrationRuns {
  std::vector<ClipRun> fitted, held_out;
};

// Loads the clips by way of the shelf, each on the rank that runs it. Super resolution runs on all
// frames, the methods that generate on one in `every`. `parts` and `pipeline` outlive the runs.
// Error: an interruption, or as Pipeline::Load.
CalibrationRuns LoadCalibrationRuns(const CalibrationRequest& request, const Pipeline& pipeline,
                                    const std::vector<const MethodInfo*>& methods,
                                    const std::vector<CalibrationPart>& parts, ClipShelf& shelf);

// The input that the losses depend on, beside the contents of files.
std::string CalibrationData(const CalibrationRequest& request, const Pipeline& pipeline,
                            const std::vector<CalibrationPart>& parts);

}  // namespace warplut
