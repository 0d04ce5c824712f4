#include "tools/view/view_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/temporary_file.h"
#include "tools/tables/record_table.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/usage_error.h"
#include "tools/view/error_map.h"
#include "tools/view/flip_picture.h"
#include "tools/view/method_frames.h"
#include "tools/view/picture_label.h"
#include "tools/view/view_page.h"
#include "tools/view/view_pictures.h"
#include "tools/view/view_video.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr int kFlipMilliseconds = 600;

void Check() { ThrowIfInterrupted("view", "the page was not written"); }

// A part of a file's name or an anchor.
std::string Plain(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    plain += std::isalnum(static_cast<unsigned char>(c)) != 0
                 ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                 : '-';
  }
  return plain;
}

// The errors of a moment in their size, labelled, side by side.
Image ErrorPicture(const std::string& frame, const std::vector<NamedPanel>& panels) {
  std::vector<Image> errors;
  for (const NamedPanel& panel : panels) {
    if (panel.note.empty()) continue;
    errors.push_back(Labelled(panel.image, frame + "  " + panel.Label()));
  }
  return SideBySide(errors);
}

class View {
 public:
  explicit View(const ViewRequest& request)
      : request_(request),
        out_(request.out),
        frames_(request.sequence.empty() ? FramesOfFolders(request.folders[0], request.folders[1],
                                                           request.reference, request.linear)
                                         : FramesOfMethods(request, out_ / "frames")),
        worst_(frames_) {}

  ViewResult Run() {
    CreateFolder(out_);
    FindWorst();
    WriteWorst();
    WriteShown();
    WriteVideoFile();
    WritePage();
    return result_;
  }

 private:
  std::size_t count() const { return frames_.files.size(); }

  void FindWorst() {
    Progress progress("looking for the worst", static_cast<double>(count()), "frames");
    for (std::size_t i = 0; i < count(); ++i) {
      Check();
      worst_.Add(i, frames_.Load(i));
      progress.Add(1);
    }
  }

  // Spread over all frames, and those of the worst windows.
  std::set<std::size_t> Shown() const {
    std::set<std::size_t> shown;
    const std::size_t wanted = std::min<std::size_t>(request_.shown, count());
    for (std::size_t i = 0; i < wanted; ++i) {
      shown.insert(wanted == 1 ? 0 : i * (count() - 1) / (wanted - 1));
    }
    for (const WorstWindow& worst : worst_.Worst()) shown.insert(worst.index);
    return shown;
  }

  void Write(const fs::path& name, const Image& image) {
    WriteImage(out_ / name, image, PixelType::kUint8);
    result_.files.push_back((out_ / name).string());
  }

  // The bytes of the image as a PNG file.
  std::string Png(const Image& image) const {
    const fs::path file = TemporaryBeside(out_ / "layer.png");
    WriteImage(file, image, PixelType::kUint8);
    std::string bytes = ReadFile(file);
    fs::remove(file);
    return bytes;
  }

  std::string Legend() const { return "errors " + ErrorLegend(request_.amplify); }

  std::string Versus() const { return frames_.HasReference() ? "the reference" : frames_.b; }

  void WriteWorst() {
    for (const WorstWindow& worst : worst_.Worst()) {
      Check();
      const ViewedFrame frame = frames_.Load(worst.index);
      const std::string title =
          fmt::format("frame {}, where {} differs most from {}: ({}, {})", frame.name, worst.source,
                      Versus(), worst.window.x, worst.window.y);
      const auto panels = PanelsOf(frames_, frame, request_.amplify);
      Write("worst-" + Plain(worst.source) + ".png",
            WindowPicture(title + "; " + Legend(), panels, worst.window));
      PageMoment moment{
          .id = "worst-" + Plain(worst.source), .title = title, .caption = Legend(), .layers = {}};
      for (const NamedPanel& panel : panels) {
        moment.layers.push_back({panel.Label(), Png(EnlargedWindow(panel.image, worst.window))});
      }
      moments_.push_back(std::move(moment));
    }
    if (moments_.empty()) {
      result_.sentences.push_back(fmt::format("{} and {} do not differ.", frames_.a, frames_.b));
    }
  }

  void WriteShown() {
    const std::set<std::size_t> shown = Shown();
    Progress progress("drawing", static_cast<double>(shown.size()), "frames");
    ContactSheet sheet;
    for (const std::size_t index : shown) {
      Check();
      const ViewedFrame frame = frames_.Load(index);
      const auto panels = PanelsOf(frames_, frame, request_.amplify);
      sheet.Add(frame.name, panels);
      const std::string plain = Plain(frame.name);
      Write("error-" + plain + ".png", Labelled(ErrorPicture(frame.name, panels), Legend()));
      WriteFile(
          out_ / ("flip-" + plain + ".png"),
          FlipPicture(Png(Labelled(frame.a, frame.name + "  " + frames_.a)),
                      Png(Labelled(frame.b, frame.name + "  " + frames_.b)), kFlipMilliseconds));
      result_.files.push_back((out_ / ("flip-" + plain + ".png")).string());
      AddMoment(frame, panels);
      progress.Add(1);
    }
    Write("sheet.png", sheet.Picture(fmt::format("{} and {}; {}", frames_.a, frames_.b, Legend())));
  }

  void AddMoment(const ViewedFrame& frame, const std::vector<NamedPanel>& panels) {
    PageMoment moment{.id = "frame-" + Plain(frame.name),
                      .title = "frame " + frame.name,
                      .caption = ScoreText(frame) + "; " + Legend(),
                      .layers = {}};
    for (const NamedPanel& panel : panels) {
      moment.layers.push_back({panel.Label(), Png(panel.image)});
    }
    moments_.push_back(std::move(moment));
  }

  std::string ScoreText(const ViewedFrame& frame) const {
    const auto score = [](const Image& image, const Image& truth) {
      return PsnrCell(PsnrOf(image, truth)).text;
    };
    if (!frame.HasReference()) {
      return fmt::format("PSNR of {} against {}: {} dB", frames_.a, frames_.b,
                         score(frame.a, frame.b));
    }
    return fmt::format("PSNR of {}: {} dB, of {}: {} dB", frames_.a,
                       score(frame.a, frame.reference), frames_.b, score(frame.b, frame.reference));
  }

  void WriteVideoFile() {
    Progress progress("drawing the video", static_cast<double>(count()), "frames");
    const std::string why =
        WriteVideo(frames_, request_.amplify, request_.rate, out_ / "video.mp4", [&] {
          Check();
          progress.Add(1);
        });
    if (why.empty()) {
      result_.files.push_back((out_ / "video.mp4").string());
    } else {
      result_.sentences.push_back(why);
    }
  }

  void WritePage() {
    Check();
    std::vector<std::string> paragraphs = {
        fmt::format(
            "{} of {} frames. Colours are as displayed, with 8 bits. Errors are the largest "
            "difference of R, G, B to {}, {}.",
            Shown().size(), count(), Versus(), ErrorLegend(request_.amplify)),
        "The lists choose the sides; the slider moves the border; 'flip', or the space key on a "
        "frame, changes from one side to the other."};
    for (const std::string& sentence : result_.sentences) paragraphs.push_back(sentence);
    WriteFile(out_ / "index.html",
              ViewPage(fmt::format("{} and {}", frames_.a, frames_.b), paragraphs, moments_));
    result_.files.push_back((out_ / "index.html").string());
    result_.sentences.insert(result_.sentences.begin(),
                             "Errors in pictures are " + ErrorLegend(request_.amplify) + ".");
  }

  const ViewRequest& request_;
  const fs::path out_;
  const ViewedFrames frames_;
  WorstWindows worst_;
  std::vector<PageMoment> moments_;
  ViewResult result_;
};

}  // namespace

ViewResult RunView(const ViewRequest& request) {
  std::string why;
  RequireUsage(request.IsValid(&why), why);
  RequireWritableFolder(request.out);
  return View(request).Run();
}

}  // namespace warplut
