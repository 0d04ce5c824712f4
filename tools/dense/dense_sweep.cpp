#include "tools/dense/dense_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/terminal/interrupt.h"

namespace warplut {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

const Columns<SweepCell> kCellColumns = {
    {"angle", "", [](const SweepCell& c) { return NumberCell(c.angle, 1); }},
    {"fraction", "", [](const SweepCell& c) { return NumberCell(c.fraction, 3); }},
    {"hourglass_fixed_psnr", "",
     [](const SweepCell& c) { return PsnrCell(c.hourglass.fixed.psnr); }},
    {"bowtie_fixed_psnr", "", [](const SweepCell& c) { return PsnrCell(c.bowtie.fixed.psnr); }},
    {"hourglass_tracking_psnr", "",
     [](const SweepCell& c) { return PsnrCell(c.hourglass.tracking.psnr); }},
    {"bowtie_tracking_psnr", "",
     [](const SweepCell& c) { return PsnrCell(c.bowtie.tracking.psnr); }},
    {"hourglass_temporal_error", "",
     [](const SweepCell& c) { return NumberCell(c.hourglass.temporal_error, 4); }},
    {"bowtie_temporal_error", "",
     [](const SweepCell& c) { return NumberCell(c.bowtie.temporal_error, 4); }}};

const Columns<RuleScore> kRuleColumns = {
    {"rule", "rule", [](const RuleScore& r) { return TextCell(r.rule); }},
    {"fixed_psnr", "fixed: PSNR dB", [](const RuleScore& r) { return PsnrCell(r.fixed_psnr); }},
    {"tracking_psnr", "tracking: PSNR dB",
     [](const RuleScore& r) { return PsnrCell(r.tracking_psnr); }},
    {"temporal_error", "temporal",
     [](const RuleScore& r) { return NumberCell(r.temporal_error, 4); }}};

// The share of blocks to which the rule gives the hourglass: 0, 1, or 1/2 at random.
double HourglassShare(OrderRule rule, const DenseParameters& parameters, const SweepCell& cell,
                      int whole) {
  const double length = whole + cell.fraction;
  const auto x = static_cast<float>(length * std::cos(cell.angle * kRadians));
  const auto y = static_cast<float>(length * std::sin(cell.angle * kRadians));
  double share = 0;
  for (const std::uint32_t random : {0U, 1U}) {
    if (ChooseOrder(rule, parameters, x, y, random) == BlockOrder::kHourglass) share += 0.5;
  }
  return share;
}

DenseScores ScoresOf(const DenseWorld& world, const DenseJudge& judge, OrderRule rule,
                     const DenseSettings& settings) {
  DenseDisplay display{Name(rule), DenseShading::kDense, 1, settings.dense};
  display.dense.order = rule;
  std::vector<Image> shown = ShownFrames(world, display, settings.warm_up + settings.judged);
  shown.erase(shown.begin(), shown.begin() + settings.warm_up);
  return judge.Judge(shown);
}

}  // namespace

bool SweepSettings::IsValid(std::string* why) const {
  if (angles >= 2 && fractions >= 1 && whole >= 0) return dense.IsValid(why);
  if (why != nullptr) {
    *why = fmt::format(
        "The sweep has {} angles, {} fractions and {} whole pixels; expected at least 2, 1 and 0.",
        angles, fractions, whole);
  }
  return false;
}

std::vector<SweepCell> MeasureSweep(const SweepSettings& settings) {
  std::vector<SweepCell> cells;
  for (int a = 0; a < settings.angles; ++a) {
    for (int f = 0; f < settings.fractions; ++f) {
      ThrowIfInterrupted("the sweep", "nothing was printed");
      SweepCell cell;
      cell.angle = 90.0 * a / (settings.angles - 1);
      cell.fraction = static_cast<double>(f) / settings.fractions;
      const double length = settings.whole + cell.fraction;
      const DenseWorld world =
          PatternWorld(length * std::cos(cell.angle * kRadians),
                       length * std::sin(cell.angle * kRadians), settings.dense.world);
      std::vector<Frame> references;
      for (int i = 0; i < settings.dense.judged; ++i) {
        references.push_back(world.reference(settings.dense.warm_up + i));
      }
      const DenseJudge judge(std::move(references));
      cell.hourglass = ScoresOf(world, judge, OrderRule::kHourglass, settings.dense);
      cell.bowtie = ScoresOf(world, judge, OrderRule::kBowtie, settings.dense);
      cells.push_back(cell);
    }
  }
  return cells;
}

std::vector<RuleScore> ScoreRules(const std::vector<SweepCell>& cells,
                                  const DenseParameters& parameters, int whole) {
  const auto count = static_cast<double>(cells.size());
  std::vector<RuleScore> rules;
  for (const OrderRule rule : kOrderRules) {
    RuleScore score{.rule = Name(rule)};
    for (const SweepCell& cell : cells) {
      const double h = HourglassShare(rule, parameters, cell, whole);
      score.fixed_psnr += std::lerp(cell.bowtie.fixed.psnr, cell.hourglass.fixed.psnr, h) / count;
      score.tracking_psnr +=
          std::lerp(cell.bowtie.tracking.psnr, cell.hourglass.tracking.psnr, h) / count;
      score.temporal_error +=
          std::lerp(cell.bowtie.temporal_error, cell.hourglass.temporal_error, h) / count;
    }
    rules.push_back(score);
  }
  RuleScore best{.rule = "best"};
  for (const SweepCell& cell : cells) {
    best.fixed_psnr += std::max(cell.bowtie.fixed.psnr, cell.hourglass.fixed.psnr) / count;
    best.tracking_psnr += std::max(cell.bowtie.tracking.psnr, cell.hourglass.tracking.psnr) / count;
    best.temporal_error +=
        std::min(cell.bowtie.temporal_error, cell.hourglass.temporal_error) / count;
  }
  rules.push_back(best);
  return rules;
}

TextTable SweepTable(const std::vector<SweepCell>& cells, const DenseParameters& parameters,
                     int whole) {
  TextTable table{.header = {"angle"}, .rows = {}};
  for (const SweepCell& cell : cells) {
    if (cell.angle == cells.front().angle)
      table.header.push_back(fmt::format("{:.3f}", cell.fraction));
    if (cell.fraction == cells.front().fraction) {
      table.rows.push_back({fmt::format("{:.1f}", cell.angle)});
    }
    const double share = HourglassShare(OrderRule::kMixed, parameters, cell, whole);
    table.rows.back().push_back(
        fmt::format("{:+.2f} ({})", cell.hourglass.tracking.psnr - cell.bowtie.tracking.psnr,
                    share == 0.5  ? '?'
                    : share > 0.5 ? 'h'
                                  : 'b'));
  }
  return table;
}

TextTable RuleTable(const std::vector<RuleScore>& rules) {
  return RecordTable(kRuleColumns, rules);
}

Json ToJson(const std::vector<SweepCell>& cells, const std::vector<RuleScore>& rules) {
  return {{"cells", RecordsJson(kCellColumns, cells)}, {"rules", RecordsJson(kRuleColumns, rules)}};
}

}  // namespace warplut
