#include "tools/view/view_video.h"

#include <fmt/format.h>

#include <system_error>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/temporary_file.h"
#include "tools/report/process.h"
#include "tools/view/view_pictures.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "ffmpeg";

// A folder that goes with all that is in it.
class TemporaryFrames {
 public:
  explicit TemporaryFrames(const fs::path& beside)
      : path_(TemporaryBeside(beside).replace_extension()) {
    CreateFolder(path_);
  }
  ~TemporaryFrames() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFrames(const TemporaryFrames&) = delete;
  TemporaryFrames& operator=(const TemporaryFrames&) = delete;

  const fs::path& path() const { return path_; }

 private:
  const fs::path path_;
};

// The first line of what a program says.
std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

bool HasVideoProgram() {
  const ProcessResult result = RunProcess({kProgram, "-version"}, "");
  return result.found && result.code == 0;
}

std::string WriteVideo(const ViewedFrames& frames, double amplify, double rate,
                       const fs::path& file, const std::function<void()>& on_frame) {
  if (!HasVideoProgram()) return "There is no video: ffmpeg is not installed.";
  const TemporaryFrames pictures(file);
  for (std::size_t i = 0; i < frames.files.size(); ++i) {
    on_frame();
    const ViewedFrame frame = frames.Load(i);
    WriteImage(pictures.path() / fmt::format("{:05}.png", i),
               MomentPicture(frame.name, PanelsOf(frames, frame, amplify)), PixelType::kUint8);
  }
  std::string failure;
  try {
    WriteAtomically(file, [&](const fs::path& temporary) {
      // H.264 in the form that every player takes has even sides.
      const ProcessResult result =
          RunProcess({kProgram, "-y", "-loglevel", "error", "-framerate", fmt::format("{}", rate),
                      "-i", (pictures.path() / "%05d.png").string(), "-vf",
                      "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", temporary.string()},
                     "");
      if (result.code == 0) return;
      failure = FirstLine(result.err);
      throw Error(failure);
    });
  } catch (const Error&) {
    if (failure.empty()) throw;
    return fmt::format("There is no video: ffmpeg says '{}'.", failure);
  }
  return "";
}

}  // namespace warplut
