// Which sequences are valid: ranges and lengths, whoever made them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/error.h"
#include "datasets/images/image_io.h"
#include "datasets/sequence/frame_pattern.h"
#include "datasets/sequence/sequence.h"

namespace warplut {
namespace {

[[noreturn]] void Refuse(const std::string& field, const std::string& sentence) {
  throw Error(fmt::format("field '{}' {}", field, sentence));
}

void Check(bool ok, const std::string& field, double found, const std::string& expected) {
  if (!ok) Refuse(field, fmt::format("is {}; expected {}", found, expected));
}

// A name becomes a part of files' names, of which most systems bound the length at 255 bytes.
constexpr std::size_t kMaxNameBytes = 200;

void CheckName(const std::string& name) {
  const bool fits = !name.empty() && name.size() <= kMaxNameBytes;
  const bool ok = fits && std::none_of(name.begin(), name.end(), [](char c) {
                    return c == '/' || c == 127 || static_cast<unsigned char>(c) < 32;
                  });
  if (ok) return;
  Refuse("name", fmt::format("is \"{}\"; expected 1 to {} bytes, none of them '/' or a control "
                             "character",
                             name.substr(0, kMaxNameBytes), kMaxNameBytes));
}

void CheckGrids(const Sequence& s) {
  const auto side = [](const char* field, int value) {
    Check(value >= 1 && value <= kMaxImageSide, field, value,
          fmt::format("1 to {}", kMaxImageSide));
  };
  side("render.width", s.render.width);
  side("render.height", s.render.height);
  side("output.width", s.output.width);
  side("output.height", s.output.height);
  const auto scale = [](const char* field, int output, int render) {
    const bool ok =
        output >= Sequence::kMinScale * render && output <= Sequence::kMaxScale * render;
    Check(ok, field, output,
          fmt::format("{} to {} times the render grid's {}", Sequence::kMinScale,
                      Sequence::kMaxScale, render));
  };
  scale("output.width", s.output.width, s.render.width);
  scale("output.height", s.output.height, s.render.height);
}

void CheckRenderSizes(const Sequence& s) {
  if (s.render_sizes.empty()) return;
  const auto length = static_cast<std::size_t>(s.count);
  if (s.render_sizes.size() != length) {
    Refuse("render_sizes", fmt::format("has {} values; expected one for each of the {} frames",
                                       s.render_sizes.size(), length));
  }
  const auto fits = [](int size, int render, int output) {
    return size >= 1 && size <= render && output <= Sequence::kMaxScale * size;
  };
  for (std::size_t i = 0; i < length; ++i) {
    const GridSize size = s.render_sizes[i];
    if (fits(size.width, s.render.width, s.output.width) &&
        fits(size.height, s.render.height, s.output.height)) {
      continue;
    }
    Refuse(
        fmt::format("render_sizes[{}]", i),
        fmt::format("is {} x {}; expected at most {} x {}, as 'render' says, and a {}th of the "
                    "output at least",
                    size.width, size.height, s.render.width, s.render.height, Sequence::kMaxScale));
  }
  if (s.motion && (s.motion->direction == MotionDirection::kCurrentToNext ||
                   s.motion->frame_offset != 0 || s.motion->contains_jitter)) {
    Refuse("render_sizes",
           "is there, and the motion is forward flow, of another frame or with "
           "jitter; expected that of its own frame without jitter");
  }
}

void CheckExposures(const Sequence& s) {
  if (s.exposures.empty()) return;
  if (s.color_space != ColorSpace::kLinear) {
    Refuse("exposures", "is there, and the colour is srgb; expected linear colour");
  }
  if (s.exposures.size() != static_cast<std::size_t>(s.count)) {
    Refuse("exposures", fmt::format("has {} values; expected one for each of the {} frames",
                                    s.exposures.size(), s.count));
  }
  for (std::size_t i = 0; i < s.exposures.size(); ++i) {
    const double exposure = s.exposures[i];
    Check(exposure >= 1 / Sequence::kMaxExposure && exposure <= Sequence::kMaxExposure,
          fmt::format("exposures[{}]", i), exposure,
          fmt::format("1 / {0} to {0}", Sequence::kMaxExposure));
  }
}

// The patterns of every stream.
void CheckPaths(const Sequence& s) {
  const auto check = [&s](const std::string& pattern, const std::string& field) {
    std::string why;
    if (IsFramePattern(pattern, &why, s.levels_up)) return;
    Refuse("streams." + field, fmt::format("(\"{}\") {}", pattern, why));
  };
  const auto check_motion = [&check](const MotionStream& m, const std::string& stream) {
    if (m.path_x.empty() && m.path_y.empty()) return check(m.path, stream + ".path");
    check(m.path_x, stream + ".path_x");
    check(m.path_y, stream + ".path_y");
  };
  check(s.color.path, "color.path");
  if (s.depth) check(s.depth->path, "depth.path");
  if (s.motion) check_motion(*s.motion, "motion");
  if (s.reference) check(s.reference->path, "reference.path");
  if (s.reference_depth) check(s.reference_depth->path, "reference_depth.path");
  if (s.reference_motion) check_motion(*s.reference_motion, "reference_motion");
  if (s.reactive) check(s.reactive->path, "reactive.path");
  if (s.hud) check(s.hud->path, "hud.path");
  if (s.alpha) check(s.alpha->path, "alpha.path");
  if (s.reference_alpha) check(s.reference_alpha->path, "reference_alpha.path");
}

void CheckChannels(const std::vector<std::string>& channels, std::size_t expected,
                   const std::string& field) {
  if (!channels.empty() && channels.size() != expected) {
    Refuse(field, fmt::format("has {} names; expected {}", channels.size(), expected));
  }
  for (const std::string& channel : channels) {
    if (channel.empty()) Refuse(field, "has an empty name; expected the name of a channel");
  }
}

void CheckScale(double scale, double bias, const std::string& stream) {
  Check(std::isfinite(scale) && scale != 0, stream + ".scale", scale, "a number other than 0");
  Check(std::isfinite(bias), stream + ".bias", bias, "a finite number");
}

void CheckColor(const ColorStream& c, const std::string& stream) {
  CheckChannels(c.channels, c.channels.size() == 1 ? 1 : 3, stream + ".channels");
}

// The stream has one channel.
template <class Stream>
void CheckMask(const Stream& m, const std::string& stream) {
  CheckChannels(m.channels, 1, stream + ".channels");
}

void CheckAlpha(const Sequence& s) {
  if (s.alpha) CheckMask(*s.alpha, "streams.alpha");
  if (s.reference_alpha) {
    CheckMask(*s.reference_alpha, "streams.reference_alpha");
    if (!s.reference) Refuse("streams.reference_alpha", "is there; expected it with a reference");
  }
  if (s.hud && (s.alpha || s.reference_alpha)) {
    Refuse("streams.hud",
           "is there beside an alpha; expected one of them, as a frame with alpha "
           "is a layer itself");
  }
}

void CheckLayer(const LayerStream& l, const std::string& stream) {
  CheckChannels(l.channels, 4, stream + ".channels");
}

void CheckDepth(const DepthStream& d, const std::string& stream) {
  CheckChannels(d.channels, d.encoding == Encoding::kFloat ? 1 : 4, stream + ".channels");
  CheckScale(d.scale, d.bias, stream);
  if (d.kind == DepthKind::kLinear) {
    Check(std::isfinite(d.near) && d.near >= 0, stream + ".near", d.near, "0 or more");
  } else {
    Check(std::isfinite(d.near) && d.near > 0, stream + ".near", d.near,
          "more than 0, as the depth is not linear");
  }
  Check(d.far > d.near, stream + ".far", d.far, fmt::format("more than near, {}", d.near));
  Check(d.kind == DepthKind::kReversed || std::isfinite(d.far), stream + ".far", d.far,
        "a number, as only reversed depth may be infinite");
  if (d.background) {
    Check(std::isfinite(*d.background), stream + ".background", *d.background, "a finite number");
  }
}

void CheckInvalid(const MotionStream& m, const std::string& stream) {
  for (const double value : m.invalid->values) {
    Check(std::isfinite(value), stream + ".invalid", value,
          "finite numbers; NaN is invalid anyway");
  }
  const std::string& channel = m.invalid->channel;
  if (channel.empty()) return;
  if (m.path.empty() || m.channels.empty() || m.encoding != Encoding::kFloat) {
    Refuse(stream + ".invalid",
           "names a channel; expected it with one path, and with channels that name x and y");
  }
  if (std::find(m.channels.begin(), m.channels.end(), channel) != m.channels.end()) {
    Refuse(stream + ".invalid", fmt::format("names the channel \"{}\" of the motion itself; "
                                            "expected another one",
                                            channel));
  }
}

void CheckMotion(const MotionStream& m, const std::string& stream) {
  const bool two = !m.path_x.empty() || !m.path_y.empty();
  if (two && !m.path.empty()) {
    Refuse(stream + ".path", "is there beside path_x or path_y; expected one path or these two");
  }
  if (!two && m.encoding == Encoding::kRgba8Base255) {
    Refuse(stream + ".path",
           "is one file of packed values, which hold one component; expected path_x and path_y");
  }
  CheckChannels(m.channels, m.encoding == Encoding::kFloat ? 2 : 4, stream + ".channels");
  for (std::size_t c = 0; c < 2; ++c) CheckScale(m.scale[c], m.bias[c], stream);
  if (m.invalid) CheckInvalid(m, stream);
  Check(std::abs(m.frame_offset) <= 1, stream + ".frame_offset", m.frame_offset, "-1, 0 or 1");
}

void CheckJitter(const std::vector<Vec2>& jitter) {
  for (std::size_t i = 0; i < jitter.size(); ++i) {
    for (const double v : {jitter[i].x, jitter[i].y}) {
      Check(std::abs(v) <= Sequence::kMaxJitter, fmt::format("jitter.offsets[{}]", i), v,
            fmt::format("-{0} to {0} pixels of the render grid", Sequence::kMaxJitter));
    }
  }
}

void CheckCamera(const Sequence& s) {
  const auto length = static_cast<std::size_t>(s.count);
  if (!s.camera.empty() && s.camera.size() != length) {
    Refuse("camera", fmt::format("has {} values; expected one for each of the {} frames",
                                 s.camera.size(), length));
  }
  for (std::size_t i = 0; i < s.camera.size(); ++i) {
    for (const auto* matrix : {&s.camera[i].view, &s.camera[i].projection}) {
      for (const double v : *matrix)
        Check(std::isfinite(v), fmt::format("camera[{}]", i), v, "finite numbers");
    }
  }
}

void CheckNumbers(const Sequence& s) {
  if (s.numbers.empty()) return;
  const auto length = static_cast<int>(s.numbers.size());
  Check(length == s.count && s.numbers.front() == s.first, "frames.numbers", length,
        fmt::format("{} numbers that begin with {}", s.count, s.first));
  for (std::size_t i = 1; i < s.numbers.size(); ++i) {
    Check(s.numbers[i] > s.numbers[i - 1], fmt::format("frames.numbers[{}]", i), s.numbers[i],
          "more than the one before it");
  }
}

void CheckCuts(const Sequence& s) {
  for (std::size_t i = 0; i < s.cuts.size(); ++i) {
    const std::string field = fmt::format("cuts[{}]", i);
    const int cut = s.cuts[i];
    const bool there = s.numbers.empty()
                           ? cut >= s.first && cut - s.first < s.count
                           : std::binary_search(s.numbers.begin(), s.numbers.end(), cut);
    Check(there, field, cut, fmt::format("a frame number from {} to {}", s.first, s.LastNumber()));
    Check(i == 0 || cut > s.cuts[i - 1], field, cut, "more than the one before it");
  }
}

void CheckSequence(const Sequence& s) {
  CheckName(s.name);
  Check(s.first >= 0, "frames.first", s.first, "0 or more");
  Check(s.count >= 1 && s.count <= Sequence::kMaxFrames, "frames.count", s.count,
        fmt::format("1 to {}", Sequence::kMaxFrames));
  Check(s.first <= std::numeric_limits<int>::max() - s.count, "frames.first", s.first,
        "frame numbers below 2^31");
  CheckNumbers(s);
  CheckGrids(s);
  CheckPaths(s);
  CheckColor(s.color, "streams.color");
  if (s.depth) CheckDepth(*s.depth, "streams.depth");
  if (s.motion) CheckMotion(*s.motion, "streams.motion");
  if (s.reference) CheckColor(*s.reference, "streams.reference");
  if (s.reference_depth) CheckDepth(*s.reference_depth, "streams.reference_depth");
  if (s.reference_motion) {
    CheckMotion(*s.reference_motion, "streams.reference_motion");
    if (s.reference_motion->contains_jitter) {
      Refuse("streams.reference_motion.jitter",
             "is \"included\"; expected none, as references have no jitter");
    }
  }
  if (s.reactive) CheckMask(*s.reactive, "streams.reactive");
  if (s.hud) CheckLayer(*s.hud, "streams.hud");
  CheckAlpha(s);
  CheckRenderSizes(s);
  CheckExposures(s);
  CheckJitter(s.jitter);
  CheckCamera(s);
  CheckCuts(s);
}

}  // namespace

bool Sequence::UsesVersion2() const {
  const auto stored_apart = [](const std::optional<MotionStream>& m) {
    return m && (m->direction == MotionDirection::kCurrentToNext || m->frame_offset != 0 ||
                 m->contains_jitter);
  };
  return !numbers.empty() || reactive || hud || alpha || reference_alpha || !render_sizes.empty() ||
         !exposures.empty() || (depth && depth->background) ||
         (reference_depth && reference_depth->background) || stored_apart(motion) ||
         stored_apart(reference_motion);
}

bool Sequence::IsValid(std::string* why) const {
  try {
    CheckSequence(*this);
    return true;
  } catch (const Error& e) {
    if (why) *why = e.what();
    return false;
  }
}

}  // namespace warplut
