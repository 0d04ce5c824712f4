// `warplut view`: frames of two methods or two folders for the eye.
#pragma once

#include <string>
#include <vector>

#include "tools/view/view_request.h"

namespace warplut {

struct ViewResult {
  std::vector<std::string> files;      // that were written, the page last
  std::vector<std::string> sentences;  // about the pictures, and what is not there
};

// Writes into the folder `out`, each file atomically and the page last:
//   sheet.png          frames in rows: both sources, the reference, the errors
//   worst-SOURCE.png   the window where the source errs most, enlarged
//   flip-FRAME.png     an animation that changes between both sources
//   error-FRAME.png    the errors of the frame in colours
//   video.mp4          all frames, where ffmpeg is installed
//   frames/            of methods: their frames and the references
//   index.html         the page (view_page.h)
// Frames of the sheet and the page are spread over all, with those of the worst windows. Shows
// progress. Errors: a request that makes no sense (UsageError), as FramesOfFolders and
// FramesOfMethods, a folder that cannot be written, an interruption, which leaves an old page as it
// was.
ViewResult RunView(const ViewRequest& request);

}  // namespace warplut
