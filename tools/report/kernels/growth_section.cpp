#include "tools/report/kernels/growth_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "tools/bench/bench_scene.h"
#include "tools/bench/timing.h"
#include "tools/report/power_law.h"
#include "tools/report/quartiles.h"
#include "tools/report/section_time.h"

namespace warplut {
namespace {

constexpr BenchSize kSizes[] = {{320, 180}, {640, 360}, {960, 540}, {1280, 720}, {1920, 1080}};
constexpr BenchSize kQuickSizes[] = {{320, 180}, {480, 270}, {640, 360}, {960, 540}};
constexpr int kFrameCounts[] = {2, 4, 8, 16};
constexpr BenchSize kFrameSize = {640, 360};  // where frames and threads are varied
constexpr int kThreadCounts[] = {1, 2};
constexpr int kScale = 2;

enum class Subject : std::uint8_t { kSuperResolution, kInterpolation, kExtrapolation };
constexpr Subject kSubjects[] = {Subject::kSuperResolution, Subject::kInterpolation,
                                 Subject::kExtrapolation};
constexpr const char* Name(Subject subject) {
  return subject == Subject::kSuperResolution ? "sr"
         : subject == Subject::kInterpolation ? "i"
                                              : "e";
}

// One of the runtime's objects on synthetic frames, another motion at every pixel.
class Runner {
 public:
  Runner(Subject subject, BenchSize size, const WarpOptions& warp, int threads)
      : subject_(subject),
        pool_(threads),
        scene_(subject == Subject::kSuperResolution
                   ? BenchSceneOptions{.width = size.width / kScale,
                                       .height = size.height / kScale,
                                       .output_scale = kScale}
                   : BenchSceneOptions{.width = size.width, .height = size.height}),
        out_(size.width, size.height, PixelFormat::kRgba8) {
    if (subject == Subject::kSuperResolution) {
      SuperResolutionOptions options;
      options.render_width = size.width / kScale;
      options.render_height = size.height / kScale;
      options.output_width = size.width;
      options.output_height = size.height;
      options.warp = warp;
      super_resolution_ = std::make_unique<SuperResolution>(options, pool_);
    } else {
      FrameGenerationOptions options;
      options.width = size.width;
      options.height = size.height;
      options.warp = warp;
      generation_ = std::make_unique<FrameGeneration>(options, pool_);
    }
    Frame();  // first touch of the buffers
  }

  void Frame() {
    constexpr float kMiddle = 0.5f;
    if (super_resolution_) {
      super_resolution_->Process(scene_.Rendered(index_++), out_.view());
    } else if (subject_ == Subject::kInterpolation) {
      generation_->Interpolate(scene_.Displayed(), scene_.Displayed(), kMiddle, out_.view());
    } else {
      generation_->Extrapolate(scene_.Displayed(), scene_.Displayed(), kMiddle, out_.view());
    }
  }

  // Processor time of the calling thread.
  double ThreadTime(int frames) {
    return Milliseconds([&] {
      for (int f = 0; f < frames; ++f) Frame();
    });
  }

  double WallTime() {
    const SectionTime time(0);
    Frame();
    return 1e3 * time.Spent();
  }

  std::size_t MemoryBytes() const {
    return super_resolution_ ? super_resolution_->MemoryBytes() : generation_->MemoryBytes();
  }

 private:
  Subject subject_;
  ThreadPool pool_;
  BenchScene scene_;
  ImageBuffer out_;
  std::unique_ptr<SuperResolution> super_resolution_;
  std::unique_ptr<FrameGeneration> generation_;
  int index_ = 0;
};

// Costs of one subject against one of what grows.
struct Growth {
  std::vector<double> x, milliseconds, megabytes;
};

class GrowthStudy {
 public:
  GrowthStudy(const ReportInputs& inputs, ReportSection& section)
      : inputs_(inputs), section_(section), time_(inputs.seconds), rounds_(inputs.quick ? 5 : 11) {}

  void AddPixels() {
    ReportTable table =
        MakeTable("growth-pixels", "Time and memory against output pixels, one thread", "pixels");
    ReportPlot time =
        MakePlot("growth-time", "Time against pixels, one thread", "output pixels", "ms per frame");
    ReportPlot memory =
        MakePlot("growth-memory", "Memory against pixels", "output pixels", "MB of buffers");
    const std::span<const BenchSize> sizes = inputs_.quick ? std::span<const BenchSize>(kQuickSizes)
                                                           : std::span<const BenchSize>(kSizes);
    for (const Subject subject : kSubjects) {
      Growth growth;
      for (const BenchSize size : sizes) {
        inputs_.progress(share_ += 0.04,
                         fmt::format("{} {} x {}", Name(subject), size.width, size.height));
        Runner runner(subject, size, inputs_.pipeline_lut.Warp(), 1);
        if (growth.x.size() > 1 && time_.Lacks(1e-3 * growth.milliseconds.back() * 3 * rounds_)) {
          section_.failures.push_back(
              fmt::format("{} at {} x {} is left out: the time of the section was over.",
                          Name(subject), size.width, size.height));
          continue;
        }
        growth.x.push_back(static_cast<double>(size.width) * size.height);
        growth.milliseconds.push_back(Median(runner, 1));
        growth.megabytes.push_back(1e-6 * static_cast<double>(runner.MemoryBytes()));
        AddRow(table, subject, fmt::format("{} x {}", size.width, size.height), growth);
      }
      AddExponents(table, subject, growth);
      AddSeries(time, subject, growth.x, growth.milliseconds);
      AddSeries(memory, subject, growth.x, growth.megabytes);
    }
    section_.plots.push_back(std::move(time));
    section_.plots.push_back(std::move(memory));
    section_.tables.push_back(std::move(table));
  }

  void AddFrames() {
    ReportTable table = MakeTable(
        "growth-frames",
        fmt::format("Time and memory of a whole run against its frames, {} x {}, one thread",
                    kFrameSize.width, kFrameSize.height),
        "frames");
    for (const Subject subject : kSubjects) {
      Growth growth;
      Runner runner(subject, kFrameSize, inputs_.pipeline_lut.Warp(), 1);
      for (const int frames : kFrameCounts) {
        inputs_.progress(share_ += 0.02, fmt::format("{} {} frames", Name(subject), frames));
        growth.x.push_back(frames);
        growth.milliseconds.push_back(Median(runner, frames));
        growth.megabytes.push_back(1e-6 * static_cast<double>(runner.MemoryBytes()));
        AddRow(table, subject, fmt::format("{}", frames), growth);
      }
      AddExponents(table, subject, growth);
    }
    section_.tables.push_back(std::move(table));
  }

  void AddThreads() {
    ReportTable table{
        .id = "growth-threads",
        .caption = fmt::format("Time and memory against threads, {} x {}; memory in MB",
                               kFrameSize.width, kFrameSize.height),
        .table = {.header = {"method", "ms, 1 thread", "ms, 2 threads", "faster by", "MB, 1 thread",
                             "MB, 2 threads"},
                  .rows = {}}};
    for (const Subject subject : kSubjects) {
      inputs_.progress(share_ += 0.02, fmt::format("{} threads", Name(subject)));
      std::vector<double> one, two, ratios;
      Runner single(subject, kFrameSize, inputs_.pipeline_lut.Warp(), kThreadCounts[0]);
      Runner both(subject, kFrameSize, inputs_.pipeline_lut.Warp(), kThreadCounts[1]);
      for (int round = 0; round < 2 * rounds_; ++round) {
        one.push_back(single.WallTime());
        two.push_back(both.WallTime());
        ratios.push_back(one.back() / two.back());
      }
      table.table.rows.push_back(
          {Name(subject), fmt::format("{:.2f}", QuartilesOf(one).median),
           fmt::format("{:.2f}", QuartilesOf(two).median),
           fmt::format("{:.2f}", QuartilesOf(ratios).median),
           fmt::format("{:.2f}", 1e-6 * static_cast<double>(single.MemoryBytes())),
           fmt::format("{:.2f}", 1e-6 * static_cast<double>(both.MemoryBytes()))});
    }
    section_.tables.push_back(std::move(table));
  }

 private:
  static ReportTable MakeTable(const char* id, const std::string& caption, const char* what) {
    return {.id = id,
            .caption = caption,
            .table = {.header = {"method", what, "ms", "MB"}, .rows = {}}};
  }
  static ReportPlot MakePlot(const char* id, const char* caption, const char* x, const char* y) {
    return {.id = id,
            .caption = caption,
            .x_label = x,
            .y_label = y,
            .logarithmic_x = true,
            .logarithmic_y = true,
            .series = {}};
  }
  static void AddRow(ReportTable& table, Subject subject, const std::string& what,
                     const Growth& growth) {
    table.table.rows.push_back({Name(subject), what,
                                fmt::format("{:.2f}", growth.milliseconds.back()),
                                fmt::format("{:.2f}", growth.megabytes.back())});
  }
  static void AddExponents(ReportTable& table, Subject subject, const Growth& growth) {
    table.table.rows.push_back({Name(subject), "exponent",
                                ExponentText(FitPowerLaw(growth.x, growth.milliseconds)),
                                ExponentText(FitPowerLaw(growth.x, growth.megabytes))});
  }
  static void AddSeries(ReportPlot& plot, Subject subject, const std::vector<double>& x,
                        const std::vector<double>& y) {
    plot.series.push_back(
        {.name = fmt::format("{}, exponent {}", Name(subject), ExponentText(FitPowerLaw(x, y))),
         .x = x,
         .y = y,
         .line = true});
  }

  double Median(Runner& runner, int frames) {
    std::vector<double> times;
    for (int round = 0; round < rounds_; ++round) times.push_back(runner.ThreadTime(frames));
    return QuartilesOf(times).median;
  }

  const ReportInputs& inputs_;
  ReportSection& section_;
  const SectionTime time_;
  const int rounds_;
  double share_ = 0;
};

}  // namespace

ReportSection GrowthSection(const ReportInputs& inputs) {
  ReportSection section{.id = "growth", .title = "Growth with pixels, frames and threads"};
  section.paragraphs = {
      "Default options on synthetic frames with another motion at every pixel, which no tile can "
      "share: the slow case. Super resolution is x2. Times are medians of processor time, with "
      "several threads of wall time; memory is that of all buffers of the object. The exponent k "
      "of cost = c x^k is fitted by least squares of the logarithms, with its standard error: 1 is "
      "proportional, 0 does not grow."};
  GrowthStudy study(inputs, section);
  study.AddPixels();
  study.AddFrames();
  study.AddThreads();
  return section;
}

}  // namespace warplut
