#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "train/inspection/points.h"
#include "train/inspection/questions.h"

namespace warplut {
namespace {

// m = factor stored + addend for each component, pixels of the render grid.
struct Affine {
  std::array<float, 2> factor, addend;
  std::array<std::size_t, 2> channel;
};

Affine AffineOf(const MotionConvention& c, GridSize render, GridSize output) {
  const auto pixels = PixelsPer(c.unit, render, output);
  Affine affine{};
  for (std::size_t k = 0; k < 2; ++k) {
    double sign = c.negated ? -1 : 1;
    if (k == 1 && c.y_up) sign = -sign;
    affine.factor[k] = static_cast<float>(sign * pixels[k] * c.scale[k]);
    affine.addend[k] = static_cast<float>(sign * pixels[k] * c.bias[k]);
    affine.channel[k] = c.swapped ? 1 - k : k;
  }
  return affine;
}

// Warps pairs of neighbouring frames by candidates of their motion.
class MotionWarps {
 public:
  MotionWarps(const InspectedClip& clip, const std::vector<Vec2>& jitter)
      : clip_(clip), jitter_(jitter), pairs_(UsablePairs(clip)) {
    for (const FramePair& pair : pairs_) points_.push_back(MovingPoints(pair));
  }

  const std::vector<FramePair>& pairs() const { return pairs_; }

  // The errors of the candidate for every pair; empty where the motion of a pair is in no file.
  // `at_rest`: no motion at all, whatever is stored.
  std::vector<PairCost> Costs(const MotionConvention& candidate, bool at_rest) const {
    std::vector<PairCost> costs;
    for (std::size_t p = 0; p < pairs_.size(); ++p) costs.push_back(Cost(candidate, p, at_rest));
    return costs;
  }

 private:
  // The pixels that move, by either file of the pair; all of the usual grid where few rest.
  std::vector<std::array<int, 2>> MovingPoints(const FramePair& pair) const {
    std::vector<std::array<int, 2>> all, moving;
    ForPoints(clip_.render, [&](int x, int y) { all.push_back({x, y}); });
    const Image& a = clip_.frames[pair.earlier].motion;
    const Image& b = clip_.frames[pair.later].motion;
    if (a.empty() || b.empty()) return all;
    const std::array<float, 2> rest = MedianVector(b);
    const auto rests = [&](const Image& motion, int x, int y) {
      const float* v = &motion.data[motion.Index(x, y)];
      return v[0] == rest[0] && v[1] == rest[1];
    };
    const auto moves = [&](int x, int y) { return !rests(a, x, y) || !rests(b, x, y); };
    const auto count =
        std::count_if(all.begin(), all.end(), [&](const auto& p) { return moves(p[0], p[1]); });
    const double share = static_cast<double>(count) / static_cast<double>(all.size());
    if (share > 0.5 || count < 10) return all;
    const int step = std::max(1, static_cast<int>(clip_.render.width * std::sqrt(share) /
                                                  std::sqrt(double{kQuestionPoints})));
    for (int y = step / 2; y < clip_.render.height; y += step) {
      for (int x = step / 2; x < clip_.render.width; x += step) {
        if (moves(x, y)) moving.push_back({x, y});
      }
    }
    return moving;
  }

  static std::array<float, 2> MedianVector(const Image& motion) {
    std::array<float, 2> median{};
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<float> values;
      for (std::size_t i = k; i < motion.data.size(); i += 34) values.push_back(motion.data[i]);
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::nth_element(values.begin(), middle, values.end());
      median[k] = *middle;
    }
    return median;
  }

  PairCost Cost(const MotionConvention& candidate, std::size_t p, bool at_rest) const {
    const FramePair& pair = pairs_[p];
    const std::size_t pixels = candidate.forward ? pair.earlier : pair.later;
    const std::size_t other = candidate.forward ? pair.later : pair.earlier;
    const Image* stored = StoredMotion(pixels, candidate.frame_offset);
    if (stored == nullptr) return {};
    const Affine affine = AffineOf(candidate, clip_.render, clip_.output);
    const Vec2 from = JitterAt(jitter_, clip_.frames[pixels].index);
    const Vec2 to = JitterAt(jitter_, clip_.frames[other].index);
    const auto shift_x = static_cast<float>(from.x - to.x);
    const auto shift_y = static_cast<float>(from.y - to.y);
    const float sign = at_rest ? 0.0F : candidate.forward ? 1.0F : -1.0F;
    const Image& here = clip_.frames[pixels].luma;
    const Image& there = clip_.frames[other].luma;
    PairCost cost;
    for (const auto& [x, y] : points_[p]) {
      const float* v = &stored->data[stored->Index(x, y)];
      const float mx = affine.factor[0] * v[affine.channel[0]] + affine.addend[0];
      const float my = affine.factor[1] * v[affine.channel[1]] + affine.addend[1];
      const float at_x = static_cast<float>(x) + (sign == 0 ? 0.0F : sign * mx) + shift_x;
      const float at_y = static_cast<float>(y) + (sign == 0 ? 0.0F : sign * my) + shift_y;
      cost.Add(x, y, clip_.render, BilinearAt(there, at_x, at_y) - here.at(x, y));
    }
    return cost;
  }

  const Image* StoredMotion(std::size_t frame, int offset) const {
    const auto at = static_cast<std::ptrdiff_t>(frame) + offset;
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(clip_.frames.size())) return nullptr;
    const InspectedFrame& file = clip_.frames[static_cast<std::size_t>(at)];
    if (file.index != clip_.frames[frame].index + offset || file.motion.empty()) return nullptr;
    return &file.motion;
  }

  const InspectedClip& clip_;
  const std::vector<Vec2>& jitter_;
  std::vector<FramePair> pairs_;
  std::vector<std::vector<std::array<int, 2>>> points_;  // of each pair
};

// Whether stored values lie as those of motion around a middle code do.
bool MayBeEncoded(const InspectedClip& clip) {
  std::vector<float> values;
  for (const InspectedFrame& frame : clip.frames) {
    if (frame.motion.empty()) continue;
    for (std::size_t i = 0; i < frame.motion.data.size(); i += 97) {
      values.push_back(frame.motion.data[i]);
    }
  }
  if (values.empty()) return false;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  if (*least < 0 || *greatest > 1) return false;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle > 0.25F && *middle < 0.75F;
}

double LongMotion(const InspectedClip& clip, const MotionConvention& convention) {
  std::vector<float> lengths;
  for (const InspectedFrame& frame : clip.frames) {
    if (frame.motion.empty() || frame.index == 0) continue;
    const Affine affine = AffineOf(convention, clip.render, clip.output);
    ForPoints(clip.render, [&](int x, int y) {
      const float* v = &frame.motion.data[frame.motion.Index(x, y)];
      lengths.push_back(std::hypot(affine.factor[0] * v[affine.channel[0]] + affine.addend[0],
                                   affine.factor[1] * v[affine.channel[1]] + affine.addend[1]));
    });
  }
  if (lengths.empty()) return 0;
  const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 99 / 100);
  std::nth_element(lengths.begin(), at, lengths.end());
  return *at;
}

int Matches(const MotionConvention& a, const MotionConvention& b) {
  return (a.DirectionName() == b.DirectionName()) + (a.y_up == b.y_up) + (a.swapped == b.swapped) +
         (a.UnitName() == b.UnitName()) + (a.frame_offset == b.frame_offset);
}

// The best candidate; of those that are not told from it the one that is most as stated.
std::size_t Choose(const std::vector<MotionConvention>& candidates,
                   const std::vector<SampleScores>& scores, std::size_t best) {
  std::size_t chosen = best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (std::isnan(Mean(scores[i]))) continue;
    if (Difference(scores[best], scores[i]).IsTold(kLeastMargin)) continue;
    const int gain =
        Matches(candidates[i], candidates[0]) - Matches(candidates[chosen], candidates[0]);
    if (gain > 0 || (gain == 0 && Mean(scores[i]) > Mean(scores[chosen]))) chosen = i;
  }
  return chosen;
}

}  // namespace

Image MotionInPixels(const Image& stored, const MotionConvention& convention, GridSize render,
                     GridSize output) {
  const Affine affine = AffineOf(convention, render, output);
  Image motion(stored.width, stored.height, 2);
  for (std::size_t i = 0; i < motion.data.size(); i += 2) {
    for (std::size_t k = 0; k < 2; ++k) {
      motion.data[i + k] = affine.factor[k] * stored.data[i + affine.channel[k]] + affine.addend[k];
    }
  }
  return motion;
}

MotionAnswer AskMotion(const Sequence& sequence, const InspectedClip& clip,
                       const std::vector<Vec2>& jitter) {
  MotionAnswer answer;
  answer.found = StatedMotion(sequence);
  if (!sequence.motion) {
    answer.reason = "the sequence has no motion";
    return answer;
  }
  const MotionWarps warps(clip, jitter);
  if (warps.pairs().empty()) {
    answer.reason = "no two neighbouring frames could be loaded";
    return answer;
  }
  const std::vector<MotionConvention> candidates = MotionCandidates(sequence, MayBeEncoded(clip));
  const bool tiled = warps.pairs().size() < kFewestPairs;
  std::vector<SampleScores> scores(candidates.size());
  std::vector<std::vector<PairCost>> costs(candidates.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    costs[i] = warps.Costs(candidates[i], false);
    scores[i] = ScoresOf(costs[i], tiled);
  });
  const SampleScores rest = ScoresOf(warps.Costs(candidates[0], true), tiled);

  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (Mean(scores[i]) > Mean(scores[best]) || std::isnan(Mean(scores[best]))) best = i;
  }
  answer.over_stated = Difference(scores[best], scores[0]);
  const std::size_t chosen = Choose(candidates, scores, best);
  answer.found = candidates[chosen];
  answer.over_rest = Difference(scores[chosen], rest);
  answer.largest = LongMotion(clip, answer.found);
  for (std::size_t p = 0; p < warps.pairs().size(); ++p) {
    answer.pair_errors.push_back(costs[chosen][p].Mean());
    answer.pair_frames.push_back(clip.frames[warps.pairs()[p].later].index);
  }

  using Name = std::string (MotionConvention::*)() const;
  constexpr std::array<std::pair<const char*, Name>, 5> kQuestions = {
      {{"direction", &MotionConvention::DirectionName},
       {"y axis", &MotionConvention::YName},
       {"channels", &MotionConvention::AxesName},
       {"unit", &MotionConvention::UnitName},
       {"frame of the file", &MotionConvention::FrameName}}};
  for (const auto& [question, name] : kQuestions) {
    std::vector<std::string> values;
    for (const MotionConvention& candidate : candidates) values.push_back((candidate.*name)());
    answer.rankings.push_back(RankValues(question, values, scores, values[0]));
  }
  constexpr double kMoves = 0.02;
  if (answer.largest < kMoves) {
    answer.reason = "nothing moves";
  } else if (!answer.over_rest.IsTold(kLeastMargin)) {
    answer.reason = "no convention explains the frames better than no motion does";
  }
  if (!answer.reason.empty()) {
    answer.found = candidates[0];
    for (Ranking& ranking : answer.rankings) {
      ranking.verdict = Verdict::kCannotTell;
      ranking.found = ranking.stated;
      ranking.reason = answer.reason;
    }
    return answer;
  }
  answer.verdict =
      answer.over_stated.IsTold(kLeastMargin) ? Verdict::kContradicts : Verdict::kAgrees;
  return answer;
}

}  // namespace warplut
