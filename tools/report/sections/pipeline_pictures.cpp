#include "tools/report/sections/pipeline_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tools/judge/sequence_scores.h"
#include "tools/pictures/sequence_pictures.h"
#include "tools/pipeline.h"
#include "train/replay/judged_frames.h"

namespace warplut {
namespace {

constexpr const char* kReference = "reference";

Image Cut(const Image& image, const PictureWindow& window) {
  Image part(std::min(kWindowSide, image.width - window.x),
             std::min(kWindowSide, image.height - window.y), 3);
  for (int y = 0; y < part.height; ++y) {
    const float* from = &image.data[image.Index(window.x, window.y + y)];
    std::copy_n(from, std::size_t{3} * static_cast<std::size_t>(part.width),
                &part.data[part.Index(0, y)]);
  }
  return part;
}

class PictureMaker {
 public:
  PictureMaker(const ReportInputs& inputs, const ReportClip& clip, Executor& executor)
      : inputs_(inputs), clip_(clip), executor_(executor) {}

  // The first window of each kind of `method`, among the later half of the frames, where there is a
  // history. A place that is the first of both kinds is taken once.
  std::vector<PictureWindow> Windows(const MethodInfo& method) {
    WindowChooser chooser(clip_.dense);
    Run(method, [&](const ShownFrame& shown) {
      if (2 * shown.frame >= static_cast<int>(clip_.dense.frames.size())) chooser.Add(shown);
    });
    std::vector<PictureWindow> first;
    for (const PictureWindow& window : chooser.Windows()) {
      if (std::none_of(first.begin(), first.end(), [&](const PictureWindow& other) {
            return other.kind == window.kind ||
                   (other.frame == window.frame && other.x == window.x && other.y == window.y);
          })) {
        first.push_back(window);
      }
    }
    return first;
  }

  // The windows as the method shows them.
  std::vector<Image> Shown(const MethodInfo& method, const std::vector<PictureWindow>& windows) {
    std::vector<Image> images(windows.size());
    Run(method, [&](const ShownFrame& shown) {
      for (std::size_t w = 0; w < windows.size(); ++w) {
        if (windows[w].frame != shown.frame) continue;
        images[w] = Cut(JudgedImage(shown.image, clip_.dense.encoding), windows[w]);
      }
    });
    return images;
  }

  std::vector<Image> Reference(const std::vector<PictureWindow>& windows) const {
    std::vector<Image> images;
    for (const PictureWindow& window : windows) {
      const ClipFrame& frame = clip_.dense.frames[static_cast<std::size_t>(window.frame)];
      images.push_back(Cut(JudgedImage(frame.reference.view(), clip_.dense.encoding), window));
    }
    return images;
  }

  std::string Caption(const PictureWindow& window) const {
    return fmt::format(
        "{}, frame {}, {}", clip_.name,
        clip_.dense.frames[static_cast<std::size_t>(window.frame)].number,
        window.kind == "error" ? "where the error is largest" : "where most was just revealed");
  }

 private:
  void Run(const MethodInfo& method, const ShownFrameSink& sink) {
    const ModeRunOptions options = ReportRunOptions(inputs_, method);
    RunMode(clip_.ClipFor(method.generation != Generation::kNone), options, executor_,
            [&](const ShownFrame& shown) {
              if (IsJudged(method, shown)) sink(shown);
            });
  }

  const ReportInputs& inputs_;
  const ReportClip& clip_;
  Executor& executor_;
};

}  // namespace

std::vector<ReportPicture> PipelinePictures(const ReportInputs& inputs, const ReportClip& clip,
                                            Executor& executor) {
  PictureMaker maker(inputs, clip, executor);
  std::vector<ReportPicture> pictures;
  // Each pair under one slider: `left` (null: the reference), then `right`, whose windows they are.
  const auto add = [&](const MethodInfo* left, const MethodInfo& right,
                       const std::vector<PictureWindow>& windows) {
    const std::vector<Image> a =
        left != nullptr ? maker.Shown(*left, windows) : maker.Reference(windows);
    const std::vector<Image> b = maker.Shown(right, windows);
    for (std::size_t w = 0; w < windows.size(); ++w) {
      if (a[w].empty() || b[w].empty()) continue;
      pictures.push_back({.caption = maker.Caption(windows[w]),
                          .left_name = left != nullptr ? left->name : kReference,
                          .right_name = right.name,
                          .left = a[w],
                          .right = b[w]});
    }
  };
  const MethodInfo &sr = MethodOf("sr"), &bilinear = MethodOf("bilinear"), &i = MethodOf("i");
  const std::vector<PictureWindow> windows = maker.Windows(sr);
  add(&bilinear, sr, windows);
  add(nullptr, sr, windows);
  add(nullptr, i, maker.Windows(i));
  return pictures;
}

}  // namespace warplut
