// warplut eval: a LUT against other filters, under protocols of repeated warps; or methods on
// sequences.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "datasets/file.h"
#include "datasets/image_io.h"
#include "luts/bake/table_io.h"
#include "tools/command.h"
#include "tools/command_judge.h"
#include "tools/interrupt.h"
#include "tools/judge/eval_report.h"
#include "tools/judge/image_set.h"
#include "tools/judge/protocol_filter.h"
#include "tools/pictures/warp_picture.h"
#include "tools/progress.h"
#include "tools/table_format.h"
#include "tools/thread_limit.h"
#include "train/metrics/luma.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// Pictures are made for so many of the images, spread over them, after so many warps.
constexpr std::size_t kPictures = 4;
constexpr int kPictureWarps = 24;

struct EvalArguments {
  std::vector<std::string> images;
  std::vector<int> warps = {6, 12, 24, 64};
  std::vector<std::string> offsets = {Name(Offsets::kHalf), Name(Offsets::kRandom),
                                      Name(Offsets::kPan)};
  std::vector<std::string> against = {"bilinear", "catmull-rom", "keys:-0.58", kBestKeys};
  std::string format = Name(TableFormat::kI16);
  int trajectories = 3;
  int crop = 448;
  std::uint64_t seed = 1;
  JudgeArguments sequence;  // all that sequences take, and what images share with them
};

std::vector<Protocol> Protocols(const EvalArguments& arguments) {
  std::vector<Protocol> protocols;
  for (const int warps : arguments.warps) {
    for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom, Offsets::kPan}) {
      const auto& asked = arguments.offsets;
      if (std::find(asked.begin(), asked.end(), Name(offsets)) == asked.end()) continue;
      RequireUsage(
          offsets != Offsets::kHalf || warps % 2 == 0,
          fmt::format("--warps has {}; with half offsets only even numbers return to the start.",
                      warps));
      RequireUsage(offsets != Offsets::kPan || warps >= 2,
                   "--warps has 1; a pan returns to the start after 2 or more.");
      protocols.push_back({.warps = warps, .offsets = offsets});
    }
  }
  return protocols;
}

std::vector<Image> LumaCrops(const std::vector<TrainImage>& images, int side) {
  std::vector<Image> crops;
  for (const TrainImage& image : images) {
    if (image.image.width < kProtocolMinSide || image.image.height < kProtocolMinSide) {
      throw Error(fmt::format("{} is {} x {}; expected at least {} x {}.", image.record.name,
                              image.image.width, image.image.height, kProtocolMinSide,
                              kProtocolMinSide));
    }
    crops.push_back(CenterCrop(Luma(image.image), side));
  }
  return crops;
}

// Scores every filter; progress counts warps.
void Score(const EvalArguments& arguments, const std::vector<Image>& images,
           const ProtocolFilter& lut, EvalReport& report) {
  ProtocolOptions options{
      .trajectories = arguments.trajectories, .seed = arguments.seed, .on_warps = {}};
  double total = ScoreFilterWarps(report.protocols, options, images.size());
  for (const std::string& name : arguments.against) {
    total += ScoreNamedWarps(name, report.protocols, options, images.size());
  }
  Progress progress("warping", total, "warps");
  options.on_warps = [&](int warps) {
    ThrowIfInterrupted("eval", "nothing was printed");
    progress.Add(warps);
  };
  report.judged = ScoreFilter(lut, report.protocols, images, options);
  for (const std::string& name : arguments.against) {
    report.others.push_back(ScoreNamed(name, report.protocols, images, options));
  }
}

void WritePictures(const EvalArguments& arguments, const std::vector<TrainImage>& images,
                   const ProtocolFilter& lut) {
  const fs::path folder = arguments.sequence.pictures;
  CreateFolder(folder);
  const ProtocolFilter filters[] = {NamedFilter("catmull-rom"), lut};
  const std::size_t count = std::min(kPictures, images.size());
  for (std::size_t i = 0; i < count; ++i) {
    const TrainImage& image = images[i * images.size() / count];
    constexpr std::size_t kMaxStem = 200;  // bytes of a file's name, of which systems take 255
    std::string name = image.record.name;
    std::replace(name.begin(), name.end(), '/', '-');
    name = fs::path(name).stem().string();
    if (name.size() > kMaxStem) name = name.substr(name.size() - kMaxStem);
    for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom}) {
      const Protocol protocol{.warps = kPictureWarps, .offsets = offsets};
      const fs::path file =
          folder / fmt::format("{}-{}-{}.png", name, kPictureWarps, Name(offsets));
      WriteImage(file, WarpPicture(image.image, filters, protocol, arguments.seed),
                 PixelType::kUint8);
    }
  }
}

void CheckImageArguments(const EvalArguments& arguments) {
  RequireUsage(!arguments.images.empty(),
               "there is nothing to judge; expected --images or --sequence");
  RequireUsage(!arguments.sequence.pipeline.lut.empty(),
               "--lut is required to judge a LUT on images");
  RequireUsage(
      arguments.crop == 0 || arguments.crop >= kProtocolMinSide,
      fmt::format("--crop is {}; expected 0 or at least {}.", arguments.crop, kProtocolMinSide));
  for (const std::string& name : arguments.against) {
    if (FindFamily(name) == nullptr) NamedFilter(name);
  }
  for (const std::string& target : arguments.sequence.targets) {
    const std::string against = ParseScoreTarget(target).against;
    RequireUsage(std::find(arguments.against.begin(), arguments.against.end(), against) !=
                     arguments.against.end(),
                 fmt::format("the target '{}' names a filter that --against does not.", target));
  }
}

ExitCode RunImageEval(const EvalArguments& arguments) {
  AsUsage([&] { CheckImageArguments(arguments); });
  EvalReport report;
  report.lut = arguments.sequence.pipeline.lut;
  report.lookup = Name(LookupOf(arguments.sequence.pipeline));
  report.crop = arguments.crop;
  report.protocols = Protocols(arguments);

  const LoadedTable loaded =
      LoadTable(arguments.sequence.pipeline.lut, TableFormatOf(arguments.format));
  report.name = loaded.name;
  const Table table(loaded.table.view());
  const Lookup lookup = LookupOf(arguments.sequence.pipeline);
  const ProtocolFilter lut =
      RuntimeFilter(loaded.name, {.filter = Filter::kLut, .table = &table, .lookup = lookup});

  const std::vector<TrainImage> images =
      LoadImages({arguments.images.begin(), arguments.images.end()}, &report.tone_mapped);
  report.images = images.size();
  Score(arguments, LumaCrops(images, arguments.crop), lut, report);
  for (const std::string& text : arguments.sequence.targets) {
    const auto missed =
        MissedProtocols(ParseScoreTarget(text), report.judged, report.others, report.protocols);
    report.missed.insert(report.missed.end(), missed.begin(), missed.end());
  }

  if (arguments.sequence.json) {
    PrintJson(ToJson(report));
  } else {
    if (arguments.sequence.markdown) {
      Print(ToMarkdown(ScoreTable(report)));
    } else {
      Print(fmt::format("{} on {} images, {} lookup\n", report.name, report.images, report.lookup) +
            ToneMappedText(report.tone_mapped, report.images) + ToText(ScoreTable(report)));
    }
    for (const std::string& sentence : report.missed) Print("missed: " + sentence + "\n");
  }
  // After the scores, which a picture that cannot be written does not take along.
  if (!arguments.sequence.pictures.empty()) WritePictures(arguments, images, lut);
  return report.missed.empty() ? ExitCode::kDone : ExitCode::kMissed;
}

ExitCode RunEval(const EvalArguments& arguments) {
  if (!arguments.sequence.sequences.empty()) return RunJudge(arguments.sequence);
  if (!arguments.sequence.pictures.empty()) RequireWritableFolder(arguments.sequence.pictures);
  const ThreadLimit limit(arguments.sequence.pipeline.threads);
  return RunImageEval(arguments);
}

}  // namespace

void AddEvalCommand(Command app, CommandRun* run) {
  const auto arguments = std::make_shared<EvalArguments>();
  EvalArguments& a = *arguments;
  Command command = app.AddCommand(
      "eval", "Judge a table by repeated warps (or, as judge does, methods on sequences)");
  CommandOption images = command.Add("--images", a.images,
                                     "Images, folders of images, or sequences (their references)");
  AddSequenceOptions(command, &a.sequence).Excludes(images);
  command.Add("--warps", a.warps, "Numbers of warps to judge after")
      .Separated()
      .Within(1, 1 << 20)
      .ShowDefault();
  command
      .Add("--offsets", a.offsets,
           "Kinds of offsets: half (by (1/2, 1/2) and back), random (back to the start), pan (one "
           "and the same)")
      .Separated()
      .OneOf({Name(Offsets::kHalf), Name(Offsets::kRandom), Name(Offsets::kPan)})
      .ShowDefault();
  command
      .Add("--against", a.against,
           "Filters to compare with: best-keys, best-spline (the best A or K each time), "
           "kaiser6:B, lanczos3, " +
               WarpNames())
      .Separated()
      .ShowDefault();
  command.Add("--format", a.format, "Storage format in which a fit or an .exr is judged")
      .OneOf(TableFormatNames())
      .ShowDefault();
  command.Add("--trajectories", a.trajectories, "Number of random trajectories for each image")
      .Within(1, 256)
      .ShowDefault();
  command
      .Add("--crop", a.crop,
           "Side of the window in the middle of each image; 0 judges whole images")
      .Within(0, 1 << 15)
      .ShowDefault();
  command.Add("--seed", a.seed, "Seed of the random trajectories").ShowDefault();
  command.Add("--target", a.sequence.targets,
              std::string("Targets for the SSIM, more than MARGIN above FILTER's: ") +
                  kScoreTargetForm +
                  "; on sequences the least values of a method: METHOD,PSNR,SSIM");
  command.Add("--pictures", a.sequence.pictures,
              "Folder for pictures: original, Catmull-Rom and the table after 24 warps; on "
              "sequences the windows where the first method errs most");
  CommandOption markdown =
      command.AddFlag("--markdown", a.sequence.markdown, "Print the table as Markdown");
  markdown.Excludes(AddJsonOption(command, &a.sequence.json));
  command.OnParsed([arguments, run] { *run = [arguments] { return RunEval(*arguments); }; });
}

}  // namespace warplut
