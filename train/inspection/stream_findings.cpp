#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/camera_fill.h"
#include "train/inspection/findings.h"
#include "train/inspection/points.h"
#include "train/replay/image_views.h"
#include "train/replay/motion_step.h"

namespace warplut {
namespace {

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

class StreamFaults {
 public:
  StreamFaults(const Sequence& sequence, const InspectedClip& clip, const MotionAnswer& motion,
               const JitterAnswer& jitter)
      : sequence_(sequence),
        clip_(clip),
        motion_(motion),
        cycle_(JitterOf(sequence, jitter.found)),
        jittered_motion_(jitter.contains_jitter) {
    for (const InspectedFrame& frame : clip.frames) {
      in_pixels_.push_back(frame.motion.empty() ? Image()
                                                : MotionInPixels(frame.motion, motion.found,
                                                                 clip.render, clip.output));
    }
  }

  std::vector<Finding> Find() {
    if (sequence_.motion) {
      Quantised();
      Sentinel();
      FirstFrame();
      Sky();
      CameraMotion();
    }
    if (sequence_.depth) {
      HugeBackground();
      FewDepths();
    }
    ColourSpace();
    Filtered();
    return std::move(findings_);
  }

 private:
  void Add(const char* what, Severity severity, std::string sentence) {
    findings_.push_back({what, severity, std::move(sentence)});
  }

  void Quantised() {
    double step = 0;
    for (const Image& motion : in_pixels_) {
      if (!motion.empty()) step = std::max(step, MotionStep(ToMotionBuffer(motion).view()));
    }
    if (step < kQuantisedStep) return;
    Add("quantised motion", Severity::kNote,
        fmt::format("Motion comes in steps of about {:.2g} pixels. The motion filter removes the "
                    "steps (--motion-filter auto does so by itself).",
                    step));
  }

  // One vector that many pixels have exactly, far from all others, that explains nothing.
  void Sentinel() {
    for (std::size_t i = 1; i < clip_.frames.size(); ++i) {
      const Image& motion = in_pixels_[i];
      if (motion.empty()) continue;
      std::map<std::pair<float, float>, int> counts;
      for (std::size_t p = 0; p < motion.data.size(); p += 2) {
        if (std::hypot(motion.data[p], motion.data[p + 1]) > 8) {
          ++counts[{motion.data[p], motion.data[p + 1]}];
        }
      }
      const std::pair<float, float>* most = nullptr;
      int times = 0;
      for (const auto& [vector, count] : counts) {
        if (count > times) {
          most = &vector;
          times = count;
        }
      }
      const auto pixels = static_cast<double>(motion.pixels());
      if (most == nullptr || times < std::max(16.0, 1e-3 * pixels)) continue;
      if (IsOutsideMark(*most) || !IsApart(motion, *most) || !IsWrong(i, *most)) continue;
      const std::size_t k = motion_.found.swapped ? 1 : 0;
      const auto stored = StoredAt(i, *most);
      Add("invalid motion", Severity::kWarning,
          fmt::format("{:.2f} % of the pixels of frame {} have exactly the motion ({:.6g}, {:.6g}) "
                      "as stored, which explains nothing there: it marks what is not known. Add "
                      "\"invalid\": {:.9g} to the motion.",
                      100 * times / pixels, sequence_.Number(clip_.frames[i].index), stored[0],
                      stored[1], motion_.found.scale[0] * stored[k] + motion_.found.bias[0]));
      return;
    }
  }

  // The value that the built-in scenes write where a surface was behind the camera.
  bool IsOutsideMark(const std::pair<float, float>& v) const {
    return std::abs(v.first - 2.0F * static_cast<float>(clip_.render.width)) < 0.01F &&
           std::abs(v.second - 2.0F * static_cast<float>(clip_.render.height)) < 0.01F;
  }

  std::array<double, 2> StoredAt(std::size_t frame, const std::pair<float, float>& v) const {
    for (std::size_t p = 0; p < in_pixels_[frame].data.size(); p += 2) {
      if (in_pixels_[frame].data[p] == v.first && in_pixels_[frame].data[p + 1] == v.second) {
        return {clip_.frames[frame].motion.data[p], clip_.frames[frame].motion.data[p + 1]};
      }
    }
    return {};
  }

  // Whether few other vectors lie near it: those of a surface that moves so would.
  static bool IsApart(const Image& motion, const std::pair<float, float>& v) {
    const double length = std::hypot(double{v.first}, v.second);
    std::size_t near = 0, same = 0;
    for (std::size_t p = 0; p < motion.data.size(); p += 2) {
      const double distance =
          std::hypot(motion.data[p] - double{v.first}, motion.data[p + 1] - double{v.second});
      if (distance == 0) {
        ++same;
      } else if (distance < 0.2 * length) {
        ++near;
      }
    }
    return near * 20 < same;
  }

  bool IsWrong(std::size_t frame, const std::pair<float, float>& v) const {
    const InspectedFrame& here = clip_.frames[frame];
    const InspectedFrame& before = clip_.frames[frame - 1];
    if (!here.Follows(before) || here.luma.empty() || before.luma.empty()) return false;
    int points = 0, explained = 0;
    for (int y = 0; y < clip_.render.height; ++y) {
      for (int x = 0; x < clip_.render.width; ++x) {
        const float* m = &in_pixels_[frame].data[in_pixels_[frame].Index(x, y)];
        if (m[0] != v.first || m[1] != v.second) continue;
        ++points;
        const float value = BilinearAt(before.luma, x - m[0], y - m[1]);
        if (std::abs(value - here.luma.at(x, y)) < 0.03F) ++explained;
      }
    }
    return explained * 2 < points;
  }

  void FirstFrame() {
    if (clip_.frames.size() < 2 || clip_.frames[0].index != 0) return;
    const auto is_zero = [](const Image& motion) {
      return std::all_of(motion.data.begin(), motion.data.end(), [](float v) { return v == 0; });
    };
    if (in_pixels_[0].empty() || in_pixels_[1].empty()) return;
    if (!is_zero(clip_.frames[0].motion) || is_zero(clip_.frames[1].motion)) return;
    Add("first motion", Severity::kNote,
        "The first frame has no motion. A first frame counts as a cut, so nothing is lost.");
  }

  // The depth that the farthest pixels share, and whether enough of them do.
  static bool BackgroundDepth(const Image& depth, bool nearer_is_larger, float* value) {
    if (depth.empty()) return false;
    const auto worse = [&](float a, float b) { return nearer_is_larger ? a > b : a < b; };
    float farthest = depth.data[0];
    for (const float z : depth.data) {
      if (worse(farthest, z)) farthest = z;
    }
    const auto count = std::count(depth.data.begin(), depth.data.end(), farthest);
    *value = farthest;
    return count * 50 > static_cast<std::ptrdiff_t>(depth.data.size());
  }

  void Sky() {
    if (!sequence_.depth) return;
    const bool nearer = StatedDepth(*sequence_.depth).nearer_is_larger;
    int frames = 0, still = 0;
    for (std::size_t i = 1; i < clip_.frames.size(); ++i) {
      const InspectedFrame& frame = clip_.frames[i];
      float background = 0;
      if (frame.cut || in_pixels_[i].empty()) continue;
      if (!BackgroundDepth(frame.depth, nearer, &background)) continue;
      std::vector<double> world;
      std::size_t sky = 0, zero = 0;
      for (std::size_t p = 0; p < frame.depth.data.size(); ++p) {
        const float mx = in_pixels_[i].data[2 * p], my = in_pixels_[i].data[2 * p + 1];
        if (frame.depth.data[p] == background) {
          ++sky;
          zero += frame.motion.data[2 * p] == 0 && frame.motion.data[2 * p + 1] == 0;
        } else if (p % 7 == 0) {
          world.push_back(std::hypot(mx, my));
        }
      }
      ++frames;
      // A quarter of the world at rest means that the camera is.
      still += zero * 20 > sky * 19 && Quantile(std::move(world), 0.25) > 0.25;
    }
    if (frames < 1 || still * 2 < frames) return;
    Add("sky without motion", Severity::kWarning,
        sequence_.camera.empty()
            ? "The sky has motion (0, 0) although the camera moves. Give cameras to the sequence; "
              "the motion of its background then comes from them."
            : "The sky has motion (0, 0) although the camera moves; it is read as the motion that "
              "the cameras give.");
  }

  void CameraMotion() {
    if (sequence_.camera.empty() || !sequence_.depth) return;
    std::vector<double> differences, lengths;
    for (std::size_t i = 1; i < clip_.frames.size(); ++i) {
      const InspectedFrame& frame = clip_.frames[i];
      const auto index = static_cast<std::size_t>(frame.index);
      if (frame.index == 0 || frame.cut || in_pixels_[i].empty() || motion_.found.forward ||
          motion_.found.frame_offset != 0) {
        continue;
      }
      Image depth;
      try {
        depth = LoadFrame(sequence_, frame.index, Streams::kDepth).depth;
      } catch (const Error&) {
        continue;
      }
      const bool finite = std::isfinite(sequence_.depth->far);
      const double unit = finite ? sequence_.depth->far : sequence_.depth->near;
      const Vec2 jitter = JitterAt(cycle_, frame.index);
      const CameraStep step(sequence_.camera[index - 1], sequence_.camera[index],
                            clip_.render.width, clip_.render.height, jitter);
      if (!step.Valid()) continue;
      ForPoints(clip_.render, [&](int x, int y) {
        const double d = depth.at(x, y);
        if (!(d > 0) || (finite && d >= 1) || std::isinf(d)) return;
        const auto camera = step.MotionAt(x, y, d * unit);
        if (!camera) return;
        const float* m = &in_pixels_[i].at(x, y);
        differences.push_back(std::hypot(camera->x - m[0], camera->y - m[1]));
        lengths.push_back(
            std::max<double>(std::hypot(camera->x, camera->y), std::hypot(m[0], m[1])));
      });
    }
    if (differences.size() < 100) return;
    const double off = Quantile(std::move(differences), 0.5);
    const double usual = Quantile(std::move(lengths), 0.5);
    if (off < 0.5 || off < 0.2 * usual || jittered_motion_) return;
    Add("cameras", Severity::kWarning,
        fmt::format("The cameras contradict the motion: half of the pixels are more than {:.2g} "
                    "pixels off, where the motion is {:.2g} pixels long. Check the matrices (row "
                    "by row, column vectors, y up) and the unit of depth.",
                    off, usual));
  }

  void HugeBackground() {
    if (sequence_.depth->kind != DepthKind::kLinear || sequence_.depth->background) return;
    for (const InspectedFrame& frame : clip_.frames) {
      float background = 0;
      if (!BackgroundDepth(frame.depth, false, &background)) continue;
      const double z = sequence_.depth->scale * background + sequence_.depth->bias;
      if (!std::isfinite(z) || z < 10 * sequence_.depth->far) continue;
      Add("background depth", Severity::kWarning,
          fmt::format("The background has the depth {:.4g}, far beyond the far plane {:.4g}. Add "
                      "\"background\": {:.9g} to the depth.",
                      z, sequence_.depth->far, z));
      return;
    }
  }

  void FewDepths() {
    for (const InspectedFrame& frame : clip_.frames) {
      if (frame.depth.pixels() < 5000) continue;
      std::set<float> values;
      for (const float z : frame.depth.data) {
        values.insert(z);
        if (values.size() > 256) return;
      }
      if (values.size() < 32) return;  // a few planes that face the camera
      Add("depth in 8 bits", Severity::kWarning,
          fmt::format("Depth has only {} different values: it was stored in 8 bits. Expected at "
                      "least 16, or the packed encoding.",
                      values.size()));
      return;
    }
  }

  void ColourSpace() {
    const bool linear = sequence_.color_space == ColorSpace::kLinear;
    std::size_t negative = 0, infinite = 0, total = 0, above = 0;
    std::vector<double> values;
    std::optional<ImageInfo> info;
    for (const InspectedFrame& frame : clip_.frames) {
      if (frame.sharp_luma.empty()) continue;
      try {
        const Image color = LoadFrame(sequence_, frame.index, Streams::kColor).color;
        if (!info) info = ReadImageInfo(FrameFiles(sequence_, frame.index, Streams::kColor)[0]);
        for (std::size_t i = 0; i < color.data.size(); ++i) {
          const float v = color.data[i];
          infinite += std::isinf(v) ? 1 : 0;
          negative += v < 0 ? 1 : 0;
          above += v > 1 ? 1 : 0;
          if (i % 31 == 0 && std::isfinite(v)) values.push_back(v);
        }
        total += color.data.size();
      } catch (const Error&) {
        continue;
      }
    }
    if (total == 0 || !info) return;
    const auto percent = [&](std::size_t n) {
      return 100.0 * static_cast<double>(n) / static_cast<double>(total);
    };
    if (negative > 0) {
      Add("negative colour", Severity::kWarning,
          fmt::format("{:.3g} % of the colour values are negative; they count as 0.",
                      percent(negative)));
    }
    if (infinite > 0) {
      Add("infinite colour", Severity::kWarning,
          fmt::format("{:.3g} % of the colour values are infinite; they count as 65504.",
                      percent(infinite)));
    }
    if (linear && info->integer && info->bits == 8) {
      Add("8-bit linear colour", Severity::kWarning,
          "The colour is stated to be linear and has 8 bits: dark parts are banded. Expected half "
          "floats, or \"color_space\": \"srgb\".");
    } else if (linear && above == 0 && EightBitLevels(values)) {
      Add("colour space", Severity::kWarning,
          "The colour is stated to be linear, but none of it is above 1 and all of it lies on "
          "8-bit "
          "levels: these are display values. Expected \"color_space\": \"srgb\".");
    }
  }

  // Whether nearly all values are multiples of 1 / 255, as far as half floats can tell.
  static bool EightBitLevels(const std::vector<double>& values) {
    const auto on_level = std::count_if(values.begin(), values.end(), [](double v) {
      return std::abs(v * 255 - std::round(v * 255)) < 0.07;
    });
    return static_cast<double>(on_level) > 0.98 * static_cast<double>(values.size());
  }

  // The energy of second differences of the render grid's pixels and of the reference at the same
  // places: samples that were averaged have less.
  void Filtered() {
    if (!sequence_.reference || clip_.render == clip_.output) return;
    const double scale_x = static_cast<double>(clip_.output.width) / clip_.render.width;
    const double scale_y = static_cast<double>(clip_.output.height) / clip_.render.height;
    double rendered = 0, referred = 0;
    for (const InspectedFrame& frame : clip_.frames) {
      if (frame.reference.empty() || frame.sharp_luma.empty()) continue;
      const auto at = [&](int x, int y) {
        return BilinearAt(frame.reference, std::round((x + 0.5) * scale_x - 0.5),
                          std::round((y + 0.5) * scale_y - 0.5));
      };
      ForPoints(clip_.render, [&](int x, int y) {
        if (x < 1 || y < 1 || x + 1 >= clip_.render.width || y + 1 >= clip_.render.height) return;
        const auto second = [&](const auto& value) {
          return 4 * value(x, y) - value(x - 1, y) - value(x + 1, y) - value(x, y - 1) -
                 value(x, y + 1);
        };
        const double r = second([&](int i, int j) { return frame.sharp_luma.at(i, j); });
        const double h = second(at);
        if (std::isnan(h)) return;
        rendered += r * r;
        referred += h * h;
      });
    }
    constexpr double kFiltered = 0.6;
    if (referred <= 0 || rendered > kFiltered * referred) return;
    Add("filtered colour", Severity::kWarning,
        fmt::format("The rendered frames have {:.0f} % of the fine detail that samples of the "
                    "reference have: they are filtered. Super resolution expects one unfiltered "
                    "sample for each pixel, with a mip bias of log2(render / output).",
                    100 * rendered / referred));
  }

  const Sequence& sequence_;
  const InspectedClip& clip_;
  const MotionAnswer& motion_;
  std::vector<Vec2> cycle_;
  bool jittered_motion_;
  std::vector<Image> in_pixels_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> FindStreamFaults(const Sequence& sequence, const InspectedClip& clip,
                                      const MotionAnswer& motion, const JitterAnswer& jitter) {
  return StreamFaults(sequence, clip, motion, jitter).Find();
}

}  // namespace warplut
