#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "train/inspection/offset_measurement.h"
#include "train/inspection/points.h"
#include "train/inspection/questions.h"

namespace warplut {
namespace {

using Cycle = std::vector<Vec2>;

// Distances of offsets that differ by less than this are as good as equal.
constexpr double kLeastJitterMargin = 1;

// One measured offset, render pixels, and the frames whose jitters it is the difference of: that of
// `here` minus that of `there` (-1: a reference, which has none).
struct Measured {
  int here, there;
  Vec2 offset;

  Vec2 Predicted(const Cycle& cycle) const {
    const Vec2 from = JitterAt(cycle, here), to = there < 0 ? Vec2{} : JitterAt(cycle, there);
    return {from.x - to.x, from.y - to.y};
  }
};

// Between neighbouring frames, warped by motion that is known.
std::vector<Measured> MeasureNeighbours(const InspectedClip& clip,
                                        const MotionConvention& convention) {
  std::vector<Measured> measured;
  for (const FramePair& pair : UsablePairs(clip)) {
    const std::size_t at = convention.forward ? pair.earlier : pair.later;
    const auto file = static_cast<std::ptrdiff_t>(at) + convention.frame_offset;
    if (file < 0 || file >= static_cast<std::ptrdiff_t>(clip.frames.size())) continue;
    const InspectedFrame& stored = clip.frames[static_cast<std::size_t>(file)];
    const InspectedFrame& here = clip.frames[at];
    const InspectedFrame& there = clip.frames[convention.forward ? pair.later : pair.earlier];
    if (stored.motion.empty() || stored.index != here.index + convention.frame_offset) continue;
    const Image motion = MotionInPixels(stored.motion, convention, clip.render, clip.output);
    const double sign = convention.forward ? 1 : -1;
    const auto offset = MeasureOffset(here.luma, there.luma, {1, 1}, [&](int x, int y) {
      const float* m = &motion.data[motion.Index(x, y)];
      return Vec2{x + sign * m[0], y + sign * m[1]};
    });
    if (offset) measured.push_back({here.index, there.index, *offset});
  }
  return measured;
}

// Between frames and their references.
std::vector<Measured> MeasureReferences(const InspectedClip& clip) {
  const Vec2 scale = {static_cast<double>(clip.output.width) / clip.render.width,
                      static_cast<double>(clip.output.height) / clip.render.height};
  std::vector<Measured> measured;
  for (const InspectedFrame& frame : clip.frames) {
    if (frame.sharp_luma.empty() || frame.reference.empty()) continue;
    const auto offset = MeasureOffset(frame.sharp_luma, frame.reference, scale, [&](int x, int y) {
      return Vec2{(x + 0.5) * scale.x - 0.5, (y + 0.5) * scale.y - 0.5};
    });
    if (offset) measured.push_back({frame.index, -1, *offset});
  }
  return measured;
}

// How the candidates fare by one kind of evidence: -10 log10 of the squared distance of what is
// measured from what they predict.
struct Evidence {
  std::vector<SampleScores> scores;
  std::size_t best = 0;
  PairedDifference over_stated;
};

Evidence Weigh(const Sequence& sequence, const std::vector<JitterConvention>& candidates,
               const std::vector<Measured>& measured) {
  constexpr double kAccuracy = 0.03;  // render pixels
  Evidence evidence;
  for (const JitterConvention& candidate : candidates) {
    const Cycle cycle = JitterOf(sequence, candidate);
    SampleScores& scores = evidence.scores.emplace_back();
    for (const Measured& one : measured) {
      const Vec2 predicted = one.Predicted(cycle);
      const double dx = one.offset.x - predicted.x, dy = one.offset.y - predicted.y;
      scores.push_back(-10 * std::log10(dx * dx + dy * dy + kAccuracy * kAccuracy));
    }
  }
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (Mean(evidence.scores[i]) > Mean(evidence.scores[evidence.best])) evidence.best = i;
  }
  evidence.over_stated = Difference(evidence.scores[evidence.best], evidence.scores[0]);
  return evidence;
}

std::size_t NoneOf(const std::vector<JitterConvention>& candidates) {
  const auto at = std::find_if(candidates.begin(), candidates.end(),
                               [](const JitterConvention& c) { return c.none; });
  return static_cast<std::size_t>(at - candidates.begin());
}

void RankJitter(const std::vector<JitterConvention>& candidates, const Evidence& evidence,
                JitterAnswer* answer) {
  using Name = std::string (JitterConvention::*)() const;
  constexpr std::array<std::pair<const char*, Name>, 4> kQuestions = {
      {{"jitter sign", &JitterConvention::SignName},
       {"jitter axes", &JitterConvention::AxesName},
       {"jitter unit", &JitterConvention::UnitName},
       {"jitter frame", &JitterConvention::FrameName}}};
  std::vector<std::string> is;
  for (const JitterConvention& candidate : candidates) {
    is.push_back(candidate.none ? "no jitter" : "jitter");
  }
  answer->rankings.push_back(
      RankValues("colour has", is, evidence.scores, "jitter", kLeastJitterMargin));
  for (const auto& [question, name] : kQuestions) {
    std::vector<std::string> values;
    std::vector<SampleScores> scores;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].none) continue;
      values.push_back((candidates[i].*name)());
      scores.push_back(evidence.scores[i]);
    }
    answer->rankings.push_back(RankValues(question, values, scores, values[0], kLeastJitterMargin));
  }
}

int Matches(const JitterConvention& a, const JitterConvention& b) {
  return (a.none == b.none) + (a.SignName() == b.SignName()) + (a.swapped == b.swapped) +
         (a.unit == b.unit) + (a.shift == b.shift);
}

std::size_t Choose(const std::vector<JitterConvention>& candidates, const Evidence& evidence) {
  std::size_t chosen = evidence.best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (Difference(evidence.scores[evidence.best], evidence.scores[i]).IsTold(kLeastJitterMargin)) {
      continue;
    }
    if (Matches(candidates[i], candidates[0]) > Matches(candidates[chosen], candidates[0])) {
      chosen = i;
    }
  }
  return chosen;
}

// The slope of the motion's median against the jitter's differences. Second differences over frames
// take out a camera that moves smoothly.
void AskContained(const InspectedClip& clip, const MotionConvention& convention, const Cycle& cycle,
                  JitterAnswer* answer) {
  answer->contained.question = "motion has the jitter";
  struct Step {
    int index;
    double motion[2], jitter[2];
  };
  std::vector<Step> steps;
  for (const InspectedFrame& frame : clip.frames) {
    const int index = frame.index - convention.frame_offset + (convention.forward ? 1 : 0);
    if (frame.motion.empty() || index < 1 || frame.cut) continue;
    const Image motion = MotionInPixels(frame.motion, convention, clip.render, clip.output);
    std::vector<double> x, y;
    ForPoints(clip.render, [&](int i, int j) {
      x.push_back(motion.at(i, j, 0));
      y.push_back(motion.at(i, j, 1));
    });
    const Vec2 now = JitterAt(cycle, index), before = JitterAt(cycle, index - 1);
    steps.push_back({index, {Median(x), Median(y)}, {now.x - before.x, now.y - before.y}});
  }
  std::vector<double> products, squares;
  std::vector<std::array<double, 2>> points;  // jitter, motion
  for (std::size_t i = 2; i < steps.size(); ++i) {
    if (steps[i].index != steps[i - 2].index + 2) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto second = [&](auto member) {
        return (steps[i].*member)[k] - 2 * (steps[i - 1].*member)[k] + (steps[i - 2].*member)[k];
      };
      points.push_back({second(&Step::jitter), second(&Step::motion)});
    }
  }
  double jj = 0, jm = 0;
  for (const auto& [j, m] : points) {
    jj += j * j;
    jm += j * m;
  }
  if (points.size() < 4 || jj < 1e-6) {
    answer->contained.reason = "too few frames, or no jitter";
    return;
  }
  const double slope = jm / jj;
  double residual = 0;
  for (const auto& [j, m] : points) residual += (m - slope * j) * (m - slope * j);
  const double error = std::sqrt(residual / (static_cast<double>(points.size()) - 1) / jj);
  Ranking& ranking = answer->contained;
  // Squared distances of the slope from that of each answer, in dB of its error.
  const double certain = std::max(error, 1e-3);
  const bool in = std::abs(slope + 1) < 0.25 && error < 0.2;
  const bool out = std::abs(slope) < 0.25 && error < 0.2;
  ranking.candidates = {
      {in ? "included" : "excluded", slope, std::abs(0.5 + slope) / certain, error, false}};
  if (!in && !out) {
    ranking.reason = "its median follows other movements more than the jitter";
    return;
  }
  ranking.found = in ? "included" : "excluded";
  ranking.verdict = Verdict::kAgrees;
  answer->contains_jitter = in;
}

void AskAlignment(const InspectedClip& clip, const Cycle& cycle, JitterAnswer* answer) {
  const std::vector<Measured> measured = MeasureReferences(clip);
  if (measured.size() < 2) return;
  SampleScores x, y;
  for (const Measured& one : measured) {
    const Vec2 predicted = one.Predicted(cycle);
    x.push_back(one.offset.x - predicted.x);
    y.push_back(one.offset.y - predicted.y);
  }
  const SampleScores zero(measured.size(), 0);
  const PairedDifference off_x = Difference(x, zero), off_y = Difference(y, zero);
  answer->alignment = {{Mean(x), Mean(y)}, {off_x.standard_error, off_y.standard_error}};
}

}  // namespace

JitterAnswer AskJitter(const Sequence& sequence, const InspectedClip& clip,
                       const MotionConvention& motion) {
  JitterAnswer answer;
  if (sequence.motion) answer.contains_jitter = sequence.motion->contains_jitter;
  if (sequence.jitter.empty()) {
    answer.reason = "the sequence has no jitter";
    AskAlignment(clip, {}, &answer);
    return answer;
  }
  const std::vector<JitterConvention> candidates = JitterCandidates(sequence);
  const std::size_t none = NoneOf(candidates);
  std::optional<Evidence> by_reference, by_neighbour;
  constexpr std::size_t kFewest = 2;
  if (const auto measured = MeasureReferences(clip); measured.size() >= kFewest) {
    by_reference = Weigh(sequence, candidates, measured);
  }
  if (const auto measured =
          sequence.motion ? MeasureNeighbours(clip, motion) : std::vector<Measured>();
      measured.size() >= kFewest) {
    by_neighbour = Weigh(sequence, candidates, measured);
  }
  if (!by_reference && !by_neighbour) {
    answer.reason = "there is neither a reference nor motion to compare frames by";
    return answer;
  }
  answer.from_references = by_reference.has_value();
  const Evidence& evidence = by_reference ? *by_reference : *by_neighbour;
  answer.over_stated = evidence.over_stated;
  answer.found = candidates[Choose(candidates, evidence)];
  RankJitter(candidates, evidence, &answer);

  // Frames that neighbours match best without jitter are not jittered, or their motion has it.
  const bool neighbours_say_none = by_neighbour && by_neighbour->best == none;
  if (answer.found.none && !by_reference) {
    AskContained(clip, motion, JitterOf(sequence, {}), &answer);
    if (answer.contains_jitter) answer.found = {};
  } else {
    AskContained(clip, motion, JitterOf(sequence, answer.found), &answer);
  }
  if (neighbours_say_none && by_reference && !answer.found.none &&
      answer.contained.verdict == Verdict::kCannotTell) {
    answer.contains_jitter = true;
    answer.contained.found = "included";
    answer.contained.verdict = Verdict::kAgrees;
  }
  answer.verdict = answer.found == JitterConvention{} ? Verdict::kAgrees : Verdict::kContradicts;
  if (answer.verdict == Verdict::kAgrees) {
    // Told as stated only if every other candidate is told from it, none of them moved by whole
    // cycles.
    const bool told = std::any_of(answer.rankings.begin(), answer.rankings.end(),
                                  [](const auto& r) { return r.verdict == Verdict::kAgrees; });
    if (!told) answer.verdict = Verdict::kCannotTell;
  }
  AskAlignment(clip, JitterOf(sequence, answer.found), &answer);
  return answer;
}

}  // namespace warplut
