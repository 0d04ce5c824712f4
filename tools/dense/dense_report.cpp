#include "tools/dense/dense_report.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "datasets/images/image_io.h"

namespace warplut {
namespace {

const Columns<DenseScores> kColumns = {
    {"display", "", [](const DenseScores& s) { return TextCell(s.display); }},
    {"samples_per_pixel", "samples",
     [](const DenseScores& s) { return NumberCell(s.samples_per_pixel, 0); }},
    {"fixed_psnr", "fixed: PSNR dB", [](const DenseScores& s) { return PsnrCell(s.fixed.psnr); }},
    {"fixed_ssim", "SSIM", [](const DenseScores& s) { return NumberCell(s.fixed.ssim, 4); }},
    {"tracking_psnr", "tracking: PSNR dB",
     [](const DenseScores& s) { return PsnrCell(s.tracking.psnr); }},
    {"tracking_ssim", "SSIM", [](const DenseScores& s) { return NumberCell(s.tracking.ssim, 4); }},
    {"temporal_error", "temporal",
     [](const DenseScores& s) { return NumberCell(s.temporal_error, 4); }},
    {"static_flicker", "static flicker",
     [](const DenseScores& s) { return NumberCell(s.static_flicker, 4); }}};

// The name of a display as part of a file name: small letters and digits with '-' between words.
std::string FileStem(const std::string& name) {
  std::string stem;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  return stem;
}

void WritePictures(const DenseJudge& judge, const std::vector<Image>& shown,
                   const std::filesystem::path& stem) {
  const int last = judge.Integrals() - 1;
  WriteImage(stem.string() + "-fixed.png", judge.Fixed(shown, last), PixelType::kUint8);
  WriteImage(stem.string() + "-tracking.png", judge.Tracking(shown, last), PixelType::kUint8);
  WriteImage(stem.string() + "-shown.png", shown.back(), PixelType::kUint8);
}

FrameScore MeanOf(const std::vector<DenseReport>& reports, std::size_t display,
                  FrameScore DenseScores::*score) {
  std::vector<FrameScore> scores;
  for (const DenseReport& report : reports) scores.push_back(report.displays[display].*score);
  return MeanScore(scores);
}

}  // namespace

bool DenseSettings::IsValid(std::string* why) const {
  const auto fail = [why](const std::string& sentence) {
    if (why != nullptr) *why = sentence;
    return false;
  };
  constexpr int kLeastSize = 22;  // the SSIM window and the border
  if (world.width < kLeastSize || world.height < kLeastSize) {
    return fail("The size is " + std::to_string(world.width) + " x " +
                std::to_string(world.height) + "; expected at least 22 x 22.");
  }
  if (warm_up < 0 || warm_up % kSlowStep != 0) {
    return fail("The warm-up is " + std::to_string(warm_up) + "; expected a multiple of 4.");
  }
  if (judged < kSlowStep || judged % kSlowStep != 0) {
    return fail("The number of judged subframes is " + std::to_string(judged) +
                "; expected a multiple of 4, at least 4.");
  }
  if (world.samples < 1 || world.samples > 65536) {
    return fail("The number of samples is " + std::to_string(world.samples) +
                "; expected 1 to 65536.");
  }
  if (!(world.speed > 0 && world.speed <= 60)) {
    return fail("The speed is " + std::to_string(world.speed) +
                "; expected more than 0, up to 60.");
  }
  DenseOptions options = dense;
  options.width = world.width;
  options.height = world.height;
  return options.IsValid(why);
}

DenseReport MeasureDense(const std::string& scene, const DenseWorld& world,
                         const DenseSettings& settings, const std::filesystem::path& pictures) {
  std::vector<Frame> references;
  for (int i = 0; i < settings.judged; ++i) {
    references.push_back(world.reference(settings.warm_up + i));
  }
  const DenseJudge judge(std::move(references));
  if (!pictures.empty()) WritePictures(judge, judge.Ideal(), pictures / (scene + "-ideal"));
  DenseReport report{scene, {}};
  for (const DenseDisplay& display : ComparedDisplays(settings.dense)) {
    std::vector<Image> shown = ShownFrames(world, display, settings.warm_up + settings.judged);
    shown.erase(shown.begin(), shown.begin() + settings.warm_up);
    DenseScores scores = judge.Judge(shown);
    scores.display = display.name;
    scores.samples_per_pixel = display.SamplesPerPixel();
    report.displays.push_back(scores);
    if (pictures.empty()) continue;
    WritePictures(judge, shown, pictures / (scene + "-" + FileStem(display.name)));
  }
  return report;
}

DenseReport MeanDenseReport(const std::vector<DenseReport>& reports) {
  DenseReport mean{"mean", reports.front().displays};
  for (std::size_t i = 0; i < mean.displays.size(); ++i) {
    DenseScores& scores = mean.displays[i];
    scores.fixed = MeanOf(reports, i, &DenseScores::fixed);
    scores.tracking = MeanOf(reports, i, &DenseScores::tracking);
    double temporal = 0, flicker = 0;
    int flickering = 0;
    for (const DenseReport& report : reports) {
      temporal += report.displays[i].temporal_error;
      if (std::isnan(report.displays[i].static_flicker)) continue;
      flicker += report.displays[i].static_flicker;
      ++flickering;
    }
    scores.temporal_error = temporal / static_cast<double>(reports.size());
    scores.static_flicker = flicker / flickering;
  }
  return mean;
}

TextTable DenseTable(const DenseReport& report) {
  TextTable table = RecordTable(kColumns, report.displays);
  table.header.insert(table.header.begin(), report.scene);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].insert(table.rows[i].begin(), report.displays[i].display);
  }
  return table;
}

Json ToJson(const DenseReport& report) {
  return {{"scene", report.scene}, {"displays", RecordsJson(kColumns, report.displays)}};
}

}  // namespace warplut
