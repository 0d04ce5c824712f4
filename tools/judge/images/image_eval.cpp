#include "tools/judge/images/image_eval.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "luts/bake/table_io.h"
#include "tools/judge/images/image_set.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/pictures/warp_picture.h"
#include "tools/table_format.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"
#include "tools/thread_limit.h"
#include "tools/usage_error.h"
#include "train/metrics/luma.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// Pictures are made for so many of the images, spread over them, after so many warps.
constexpr std::size_t kPictures = 4;
constexpr int kPictureWarps = 24;

std::vector<Protocol> Protocols(const EvalRequest& request) {
  std::vector<Protocol> protocols;
  for (const int warps : request.warps) {
    for (const Offsets offsets : {Offsets::kHalf, Offsets::kRandom, Offsets::kPan}) {
      const auto& asked = request.offsets;
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
void Score(const EvalRequest& request, const std::vector<Image>& images, const ProtocolFilter& lut,
           EvalReport& report) {
  ProtocolOptions options{
      .trajectories = request.trajectories, .seed = request.seed, .on_warps = {}};
  double total = ScoreFilterWarps(report.protocols, options, images.size());
  for (const std::string& name : request.against) {
    total += ScoreNamedWarps(name, report.protocols, options, images.size());
  }
  Progress progress("warping", total, "warps");
  options.on_warps = [&](int warps) {
    ThrowIfInterrupted("eval", "nothing was printed");
    progress.Add(warps);
  };
  report.judged = ScoreFilter(lut, report.protocols, images, options);
  for (const std::string& name : request.against) {
    report.others.push_back(ScoreNamed(name, report.protocols, images, options));
  }
}

void WritePictures(const EvalRequest& request, const std::vector<TrainImage>& images,
                   const ProtocolFilter& lut) {
  const fs::path folder = request.pictures;
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
      WriteImage(file, WarpPicture(image.image, filters, protocol, request.seed),
                 PixelType::kUint8);
    }
  }
}

void CheckRequest(const EvalRequest& request) {
  RequireUsage(!request.images.empty(),
               "there is nothing to judge; expected --images or --sequence");
  RequireUsage(!request.pipeline.lut.empty(), "--lut is required to judge a LUT on images");
  RequireUsage(
      request.crop == 0 || request.crop >= kProtocolMinSide,
      fmt::format("--crop is {}; expected 0 or at least {}.", request.crop, kProtocolMinSide));
  for (const std::string& name : request.against) {
    if (FindFamily(name) == nullptr) NamedFilter(name);
  }
  for (const std::string& target : request.targets) {
    const std::string against = ParseScoreTarget(target).against;
    RequireUsage(
        std::find(request.against.begin(), request.against.end(), against) != request.against.end(),
        fmt::format("the target '{}' names a filter that --against does not.", target));
  }
}

}  // namespace

void EvalImages(const EvalRequest& request, const std::function<void(const EvalReport&)>& print) {
  AsUsage([&] { CheckRequest(request); });
  if (!request.pictures.empty()) RequireWritableFolder(request.pictures);
  const ThreadLimit limit(request.pipeline.threads);
  EvalReport report;
  report.lut = request.pipeline.lut;
  report.lookup = Name(LookupOf(request.pipeline));
  report.crop = request.crop;
  report.protocols = Protocols(request);

  const LoadedTable loaded = LoadTable(request.pipeline.lut, TableFormatOf(request.format));
  report.name = loaded.name;
  const Table table(loaded.table.view());
  const Lookup lookup = LookupOf(request.pipeline);
  const ProtocolFilter lut =
      RuntimeFilter(loaded.name, {.filter = Filter::kLut, .table = &table, .lookup = lookup});

  const std::vector<TrainImage> images =
      LoadImages({request.images.begin(), request.images.end()}, &report.tone_mapped);
  report.images = images.size();
  Score(request, LumaCrops(images, request.crop), lut, report);
  for (const std::string& text : request.targets) {
    const auto missed =
        MissedProtocols(ParseScoreTarget(text), report.judged, report.others, report.protocols);
    report.missed.insert(report.missed.end(), missed.begin(), missed.end());
  }

  print(report);
  // After the scores, which a picture that cannot be written does not take along.
  if (!request.pictures.empty()) WritePictures(request, images, lut);
}

}  // namespace warplut
