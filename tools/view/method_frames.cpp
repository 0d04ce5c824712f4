#include "tools/view/method_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tools/judge/sequence_scores.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/terminal/warning.h"
#include "tools/thread_limit.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReferenceFolder = "reference";

class MethodFrames {
 public:
  MethodFrames(const ViewRequest& request, const fs::path& folder)
      : request_(request),
        folder_(folder),
        pipeline_(request.pipeline),
        sequence_(ReadSequence(request.sequence, request.pipeline.streams_below)),
        range_(ParseFrames(request.pipeline.frames, sequence_)),
        device_(OpenDevice(request.device)),
        pool_(request.pipeline.threads) {
    if (const auto warning = pipeline_.ScaleWarning(sequence_)) Warn(*warning);
  }

  ViewedFrames Run() {
    const MethodInfo &a = MethodOf(request_.methods[0]), &b = MethodOf(request_.methods[1]);
    ViewedFrames frames{.a = a.name, .b = b.name, .files = {}};
    for (const MethodInfo* method : {&a, &b}) RunOne(*method, method == &a, a, b);
    for (const int number : numbers_) {
      const std::string name = fmt::format("{:04}", number);
      const auto file = [&](const std::string& of) {
        return ListedImage{.file = folder_ / of / (name + ".png")};
      };
      ViewedFrames::Files& files = frames.files.emplace_back();
      files = {.name = name, .a = file(a.name), .b = file(b.name), .reference = {}};
      if (has_reference_) files.reference = file(kReferenceFolder);
    }
    return frames;
  }

 private:
  int EveryOf(const MethodInfo& method) const { return Generates(method) ? request_.every : 1; }

  ModeRunOptions OptionsOf(const MethodInfo& method) const {
    ModeRunOptions options = pipeline_.Options(method, EveryOf(method));
    options.device = device_.get();
    return options;
  }

  // The streams of what frames of the method are to look like, if the sequence has them.
  Streams TruthOf(const MethodInfo& method) const {
    const Streams available = AvailableStreams(sequence_);
    const Streams wanted = JudgingStreams(method, available);
    return Contains(available, wanted) ? wanted : Streams::kNone;
  }

  void FindCommonFrames(const Clip& clip, const MethodInfo& a, const MethodInfo& b) {
    const std::vector<int> of_a = JudgedFrames(clip, OptionsOf(a)),
                           of_b = JudgedFrames(clip, OptionsOf(b));
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::back_inserter(common_));
    if (common_.empty()) {
      throw Error(fmt::format("{} and {} show no common frame of '{}' to be judged by", a.name,
                              b.name, sequence_.name));
    }
    for (const int index : common_) {
      numbers_.push_back(clip.frames[static_cast<std::size_t>(index)].number);
    }
  }

  void RunOne(const MethodInfo& method, bool first, const MethodInfo& a, const MethodInfo& b) {
    const Clip clip =
        pipeline_.Load(sequence_, range_, {&method}, TruthOf(method), EveryOf(method));
    const ModeRunOptions options = OptionsOf(method);
    std::string why;
    if (!options.IsValid(clip, &why)) throw Error(why);
    if (first) FindCommonFrames(clip, a, b);
    CreateFolder(folder_ / method.name);
    Progress progress(fmt::format("running {}", method.name),
                      static_cast<double>(clip.frames.size()), "frames");
    RunMode(clip, options, pool_, [&](const ShownFrame& shown) {
      ThrowIfInterrupted("view", "the page was not written");
      if (shown.frame >= 0) progress.Update(shown.frame + 1);
      if (!IsJudged(method, shown) || !IsCommon(shown.frame)) return;
      Write(clip, method.name, shown.frame, JudgedImage(shown.image, clip.encoding));
      if (first) WriteReference(clip, shown);
    });
  }

  bool IsCommon(int frame) const {
    return std::binary_search(common_.begin(), common_.end(), frame);
  }

  void WriteReference(const Clip& clip, const ShownFrame& shown) {
    const ClipFrame& frame = clip.frames[static_cast<std::size_t>(shown.frame)];
    const TrueFrame truth = TrueFrameOf(frame, shown.image.width, shown.image.height);
    // Super resolution at scale 1 is no truth of itself.
    const bool known = TruthOf(*FindMethod(request_.methods[0])) != Streams::kNone;
    if (!known || truth.image.width == 0) return;
    if (!has_reference_) CreateFolder(folder_ / kReferenceFolder);
    has_reference_ = true;
    Write(clip, kReferenceFolder, shown.frame, JudgedImage(truth.image, clip.encoding));
  }

  void Write(const Clip& clip, const std::string& folder, int frame, const Image& image) const {
    const int number = clip.frames[static_cast<std::size_t>(frame)].number;
    WriteImage(folder_ / folder / fmt::format("{:04}.png", number), image, PixelType::kUint8);
  }

  const ViewRequest& request_;
  const fs::path folder_;
  const Pipeline pipeline_;
  const Sequence sequence_;
  const FrameRange range_;
  const std::unique_ptr<ModeDevice> device_;
  ThreadPool pool_;
  std::vector<int> common_;   // indices in the clip, ascending
  std::vector<int> numbers_;  // of these frames
  bool has_reference_ = false;
};

}  // namespace

ViewedFrames FramesOfMethods(const ViewRequest& request, const fs::path& folder) {
  const ThreadLimit limit(request.pipeline.threads);
  return MethodFrames(request, folder).Run();
}

}  // namespace warplut
