#include "tools/report/kernels/kernels_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tools/report/kernels/kernel_scores.h"
#include "tools/report/pareto.h"
#include "tools/report/section_time.h"
#include "train/metrics/psnr.h"

namespace warplut {
namespace {

constexpr std::size_t kRandom = static_cast<std::size_t>(OffsetSource::kRandom);
constexpr std::size_t kLong = kErrorWarps.size() - 1;

// The images that are judged with, and how long the timing takes.
struct Effort {
  int side, trajectories, width, height, repeats;
};
Effort EffortOf(bool quick) {
  return quick ? Effort{.side = 160, .trajectories = 1, .width = 640, .height = 400, .repeats = 5}
               : Effort{.side = 256, .trajectories = 2, .width = 1280, .height = 800, .repeats = 9};
}

struct KernelResult {
  const ResamplingKernel* kernel;
  double time = 0;  // ms per megapixel
  KernelErrors errors;
};

// Whether the times of two families compare.
bool AreTimesComparable(KernelFamily a, KernelFamily b) {
  return (a == KernelFamily::kPlain) == (b == KernelFamily::kPlain);
}

// For each result the name of one that dominates it, or "".
std::vector<std::string> DominatedBy(const std::vector<KernelResult>& results) {
  std::vector<std::string> names(results.size());
  for (const bool plain : {false, true}) {
    std::vector<std::size_t> members;
    std::vector<CostPoint> points;
    for (std::size_t i = 0; i < results.size(); ++i) {
      if ((results[i].kernel->family == KernelFamily::kPlain) != plain) continue;
      members.push_back(i);
      points.push_back({results[i].time, results[i].errors[kRandom][kLong].loss});
    }
    const auto dominators = Dominators(points);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (dominators[i]) names[members[i]] = results[members[*dominators[i]]].kernel->name;
    }
  }
  return names;
}

ReportTable ErrorTable(PixelFormat format, const std::vector<KernelResult>& results) {
  ReportTable table{
      .id = fmt::format("kernels-{}", Name(format)),
      .caption = fmt::format("{}: kernels, ordered by 1 - SSIM after {} warps by random offsets",
                             Name(format), kErrorWarps[kLong]),
      .table = {.header = {"kernel", "code", "reads", "ms/MP", "x Catmull-Rom"}, .rows = {}}};
  for (const OffsetSource source : kOffsetSources) {
    for (const int warps : kErrorWarps) {
      table.table.header.push_back(fmt::format("1 - SSIM, {} {}", warps, Name(source)));
    }
  }
  for (const int warps : kErrorWarps) {
    table.table.header.push_back(fmt::format("PSNR dB, {} random", warps));
  }
  table.table.header.emplace_back("dominated by");

  // Of each family of comparable times, the one that the others are divided by.
  const auto yardstick = [&](const KernelResult& result) {
    for (const KernelResult& other : results) {
      const bool plain = other.kernel->family == KernelFamily::kPlain;
      if (other.kernel->name == (plain ? "catmull-rom, plain" : "catmull-rom") &&
          AreTimesComparable(other.kernel->family, result.kernel->family)) {
        return other.time;
      }
    }
    return 0.0;
  };
  std::vector<std::string> dominated = DominatedBy(results);
  std::vector<std::size_t> order(results.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return results[a].errors[kRandom][kLong].loss < results[b].errors[kRandom][kLong].loss;
  });
  for (const std::size_t i : order) {
    const KernelResult& result = results[i];
    const double unit = yardstick(result);
    std::vector<std::string> row = {result.kernel->name, Name(result.kernel->family),
                                    result.kernel->reads, fmt::format("{:.2f}", result.time),
                                    unit > 0 ? fmt::format("{:.2f}", result.time / unit) : "-"};
    for (const auto& source : result.errors) {
      for (const KernelError& error : source) row.push_back(fmt::format("{:.4f}", error.loss));
    }
    for (const KernelError& error : result.errors[kRandom]) {
      row.push_back(fmt::format("{:.2f}", Psnr(error.mean_squared_error)));
    }
    row.push_back(dominated[i].empty() ? "-" : dominated[i]);
    table.table.rows.push_back(std::move(row));
  }
  return table;
}

ReportPlot ParetoPlot(PixelFormat format, const std::vector<KernelResult>& results) {
  ReportPlot plot{.id = fmt::format("kernels-{}", Name(format)),
                  .caption = fmt::format("{}: error after {} warps by random offsets against time; "
                                         "plain C++ compares only with plain C++",
                                         Name(format), kErrorWarps[kLong]),
                  .x_label = "ms per megapixel, one thread",
                  .y_label = "1 - SSIM",
                  .logarithmic_x = true,
                  .logarithmic_y = true,
                  .series = {}};
  const std::vector<std::string> dominated = DominatedBy(results);
  for (const KernelFamily family :
       {KernelFamily::kRuntime, KernelFamily::kPlain, KernelFamily::kOpenCv}) {
    PlotSeries series{.name = Name(family)};
    // Labels of what is on the front are placed first.
    for (const bool front : {true, false}) {
      for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].kernel->family != family || dominated[i].empty() != front) continue;
        series.x.push_back(results[i].time);
        series.y.push_back(results[i].errors[kRandom][kLong].loss);
        series.labels.push_back(results[i].kernel->name);
      }
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

class KernelStudy {
 public:
  KernelStudy(const ReportInputs& inputs, ReportSection& section)
      : inputs_(inputs), section_(section), effort_(EffortOf(inputs.quick)) {
    for (const ReportClip& clip : inputs.clips) {
      for (int t = 0; t < effort_.trajectories; ++t) {
        const std::uint64_t seed = inputs.seed * 1000 + problems_.size();
        problems_.push_back(MakeKernelProblem(clip.dense, effort_.side, seed));
      }
    }
    keys_a_ = BestKeysParameter(problems_, [&](double share) {
      inputs_.progress(kKeysShare * share, "best Keys parameter");
    });
    kernels_ = ResamplingKernels(inputs.warp_lut, static_cast<float>(keys_a_));
  }

  void Add(std::size_t number) {
    const PixelFormat format = kColorFormats[number];
    std::vector<const ResamplingKernel*> right;
    for (const ResamplingKernel& kernel : kernels_) {
      if (!kernel.Takes(format)) continue;
      const std::string wrong = CheckKernel(kernel, format);
      if (wrong.empty()) {
        right.push_back(&kernel);
      } else {
        section_.failures.push_back(fmt::format("{}: {}; it is left out.", Name(format), wrong));
      }
    }
    const auto progress = [&](double share) {
      const double formats = std::size(kColorFormats);
      inputs_.progress(
          kKeysShare + (1 - kKeysShare) * (static_cast<double>(number) + share) / formats,
          Name(format));
    };
    const std::vector<double> times = TimeKernels(
        right, format,
        {.width = effort_.width,
         .height = effort_.height,
         .repeats = effort_.repeats,
         .on_round = [&](int round) { progress(0.4 * round / (effort_.repeats + 1)); }});
    std::vector<KernelResult> results;
    for (std::size_t k = 0; k < right.size(); ++k) {
      progress(0.4 + 0.6 * static_cast<double>(k) / static_cast<double>(right.size()));
      results.push_back({right[k], times[k], JudgeKernel(*right[k], format, problems_)});
    }
    section_.plots.push_back(ParetoPlot(format, results));
    section_.tables.push_back(ErrorTable(format, results));
  }

  std::vector<std::string> Description() const {
    const Effort& e = effort_;
    return {
        fmt::format(
            "An image is warped again and again by displacements that add up to zero, stored in "
            "its format after each warp, and compared with what it was: 1 - SSIM and PSNR of luma "
            "after {} and {} warps, by random offsets, by half a pixel, and by the motion that "
            "surfaces of the sequences have themselves. {} problems: {} of the references, windows "
            "of at most {} x {} pixels, {} trajectories each.",
            kErrorWarps[0], kErrorWarps[1], problems_.size(), inputs_.clips.size(), e.side, e.side,
            e.trajectories),
        fmt::format(
            "Time is processor time of one thread on {} x {} pixels with another motion at each "
            "pixel, the median of {} rounds in which every kernel has its turn. Each result was "
            "first compared with what it must equal. The code of the runtime and of OpenCV is "
            "vectorised, plain C++ is not, and turns its history into floats first: a kernel is "
            "dominated by one of comparable code that is no slower and no worse. The exact MLP is "
            "timed on a few rows. The best Keys parameter over all of this is {:.3f}; Catmull-Rom "
            "is Keys with -0.5.",
            e.width, e.height, e.repeats, keys_a_),
        "A texture unit makes the 9 or 5 fetches of the Catmull-Rom variants at the price of one "
        "texel each; a processor does not, so their times here say nothing about a GPU."};
  }

 private:
  static constexpr double kKeysShare = 0.1;

  const ReportInputs& inputs_;
  ReportSection& section_;
  const Effort effort_;
  std::vector<KernelProblem> problems_;
  double keys_a_ = 0;
  std::vector<ResamplingKernel> kernels_;
};

}  // namespace

ReportSection KernelsSection(const ReportInputs& inputs) {
  ReportSection section{.id = "kernels", .title = "Kernels: error against time"};
  const SectionTime time(inputs.seconds);
  KernelStudy study(inputs, section);
  section.paragraphs = study.Description();
  for (std::size_t i = 0; i < std::size(kColorFormats); ++i) {
    const double before = time.Spent();
    if (i > 0 && time.Lacks(before / static_cast<double>(i))) {
      section.failures.push_back(
          fmt::format("{} is left out: the time of the section was over.", Name(kColorFormats[i])));
      continue;
    }
    study.Add(i);
  }
  if (!inputs.warp_lut.fit) {
    section.failures.push_back(
        fmt::format("The exact MLP and tables of other sizes than that of '{}' are left out: it is "
                    "a table, and only "
                    "a fit has the weights of any offset.",
                    inputs.warp_lut.name));
  }
  section.failures.emplace_back(
      "OpenCV's remap has no half floats, so it is not among the kernels of rgba16f.");
  return section;
}

}  // namespace warplut
