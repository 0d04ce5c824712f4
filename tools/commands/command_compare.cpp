// warplut compare: two folders of frames, PSNR and SSIM per frame and mean.
#include <fmt/format.h>

#include <memory>

#include "datasets/images/image_io.h"
#include "tools/commands/command.h"
#include "tools/judge/score_columns.h"
#include "tools/terminal/interrupt.h"
#include "tools/terminal/progress.h"

namespace warplut {
namespace {

struct CompareOptions {
  std::string a, b;
  int border = 0;
  bool linear = false;
  double min_psnr = 0;
  double min_ssim = -1;
  bool json = false;
};

Json ToJson(const FrameScore& score) {
  Json json = {{"name", score.name}};
  json.update(RecordJson(kFrameColumns, TimedScore{score}));
  return json;
}

std::vector<std::string> ToRow(const FrameScore& score) {
  std::vector<std::string> row = RecordRow(kFrameColumns, TimedScore{score});
  row.insert(row.begin(), score.name);
  return row;
}

// Whether a file of the pair may hold linear HDR.
bool HoldsFloats(const FramePair& pair) {
  return !ReadImageInfo(pair.a.file).integer || !ReadImageInfo(pair.b.file).integer;
}

// In which values was compared, and how the other ones are.
std::string DomainText(JudgedDomain domain, bool floats, int border) {
  if (domain == JudgedDomain::kDisplayed) {
    return fmt::format(
        "Compared as displayed (linear HDR, tone-mapped as run --score judges), border {}.\n",
        border);
  }
  return fmt::format("Compared as stored, border {}.{}\n", border,
                     floats ? " Of linear HDR, --linear compares as displayed." : "");
}

ExitCode Compare(const CompareOptions& options) {
  const std::vector<FramePair> pairs = PairFrames(options.a, options.b);
  const JudgedDomain domain = DomainOf(pairs, options.linear);
  std::vector<FrameScore> scores;
  {
    Progress progress("comparing", static_cast<double>(pairs.size()), "frames");
    for (const FramePair& pair : pairs) {
      ThrowIfInterrupted("compare", "nothing was printed");
      scores.push_back(ComparePair(pair, domain, options.border));
      progress.Add(1);
    }
  }
  const FrameScore mean = MeanScore(scores);
  const bool met = mean.psnr >= options.min_psnr && mean.ssim >= options.min_ssim;
  if (options.json) {
    Json frames = Json::array();
    for (const FrameScore& score : scores) frames.push_back(ToJson(score));
    PrintJson({{"domain", Name(domain)},
               {"border", options.border},
               {"frames", frames},
               {"mean", ToJson(mean)},
               {"targets_met", met}});
  } else {
    TextTable table = RecordHeader(kFrameColumns);
    table.header.insert(table.header.begin(), "frame");
    for (const FrameScore& score : scores) table.rows.push_back(ToRow(score));
    table.rows.push_back(ToRow(mean));
    Print(ToText(table));
    Print(DomainText(domain, HoldsFloats(pairs.front()), options.border));
    if (!met) Print("A stated target was missed.\n");
  }
  return met ? ExitCode::kDone : ExitCode::kMissed;
}

}  // namespace

void AddCompareCommand(Command app, CommandRun* run) {
  const auto options = std::make_shared<CompareOptions>();
  Command command =
      app.AddCommand("compare", "Compare two folders of frames by PSNR (RGB) and SSIM (luma)");
  command.Add("dir_a", options->a, "Images, a folder of images, or a sequence").Required();
  command.Add("dir_b", options->b, "Images to compare with, by the same file names").Required();
  command.Add("--border", options->border, "Number of pixels to cut at each edge")
      .Within(0, 4096)
      .ShowDefault();
  command.AddFlag("--linear", options->linear,
                  "Compare linear HDR files as displayed, as run --score does (a "
                  "sequence with linear colour says so itself)");
  command.Add("--min-psnr", options->min_psnr, "Least mean PSNR in dB, as a target");
  command.Add("--min-ssim", options->min_ssim, "Least mean SSIM, as a target");
  AddJsonOption(command, &options->json);
  command.OnParsed([options, run] { *run = [options] { return Compare(*options); }; });
}

}  // namespace warplut
