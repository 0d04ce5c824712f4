#include "train/inspection/inspected_clip.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/error.h"
#include "train/metrics/displayed_color.h"

namespace warplut {
namespace {

// The stream, or an empty image: that it cannot be loaded is told elsewhere.
Frame LoadOrEmpty(const Sequence& sequence, int index, Streams stream) {
  if (!Contains(AvailableStreams(sequence), stream)) return {};
  try {
    return LoadFrame(sequence, index, stream);
  } catch (const Error&) {
    return {};
  }
}

InspectedFrame LoadInspected(const Sequence& stated, const Sequence& stored, int index) {
  const bool linear = stated.color_space == ColorSpace::kLinear;
  InspectedFrame frame;
  frame.index = index;
  Frame color = LoadOrEmpty(stored, index, Streams::kColor);
  frame.cut = std::binary_search(stated.cuts.begin(), stated.cuts.end(), stated.Number(index));
  if (!stated.jitter.empty()) {
    frame.jitter = stated.jitter[static_cast<std::size_t>(index) % stated.jitter.size()];
  }
  if (!color.color.empty()) {
    frame.sharp_luma = DisplayLuma(color.color, linear);
    frame.luma = Smoothed(frame.sharp_luma);
  }
  frame.motion = LoadOrEmpty(stored, index, Streams::kMotion).motion;
  frame.depth = LoadOrEmpty(stored, index, Streams::kDepth).depth;
  const Frame reference = LoadOrEmpty(stored, index, Streams::kReference);
  if (!reference.reference.empty()) frame.reference = DisplayLuma(reference.reference, linear);
  return frame;
}

}  // namespace

std::vector<int> InspectedIndices(int count) {
  std::vector<int> indices;
  if (count <= kInspectedFrames) {
    for (int i = 0; i < count; ++i) indices.push_back(i);
    return indices;
  }
  constexpr int kRuns = kInspectedFrames / kRunFrames;
  for (int run = 0; run < kRuns; ++run) {
    const auto begin =
        static_cast<int>(static_cast<std::int64_t>(count - kRunFrames) * run / (kRuns - 1));
    for (int i = 0; i < kRunFrames; ++i) indices.push_back(begin + i);
  }
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

Sequence AsStored(const Sequence& sequence) {
  Sequence stored = sequence;
  const auto plain_motion = [](std::optional<MotionStream>& motion) {
    if (!motion) return;
    motion->scale = {1, 1};
    motion->bias = {0, 0};
    motion->units = MotionUnits::kPixels;
    motion->direction = MotionDirection::kPreviousToCurrent;
    motion->y = YAxis::kDown;
    motion->frame_offset = 0;
    motion->contains_jitter = false;
    if (!motion->invalid) motion->invalid.emplace();
    motion->invalid->values.clear();
  };
  const auto plain_depth = [](std::optional<DepthStream>& depth) {
    if (!depth) return;
    depth->scale = 1;
    depth->bias = 0;
    depth->kind = DepthKind::kLinear;
    depth->near = 0;
    depth->far = 1;
    depth->background.reset();
  };
  plain_motion(stored.motion);
  plain_motion(stored.reference_motion);
  plain_depth(stored.depth);
  plain_depth(stored.reference_depth);
  stored.camera.clear();
  return stored;
}

InspectedClip LoadInspectedClip(const Sequence& sequence,
                                const std::function<void(int)>& on_frames) {
  if (!sequence.render_sizes.empty()) {
    throw Error(fmt::format(
        "the render size of '{}' varies; expected one size, to ask for the convention (--only "
        "streams checks the files)",
        sequence.name));
  }
  const Sequence stored = AsStored(sequence);
  const std::vector<int> indices = InspectedIndices(sequence.count);
  InspectedClip clip{sequence.render, sequence.output, {}};
  clip.frames.resize(indices.size());
  constexpr std::size_t kBatch = 4;
  for (std::size_t begin = 0; begin < indices.size(); begin += kBatch) {
    const std::size_t end = std::min(begin + kBatch, indices.size());
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      clip.frames[i] = LoadInspected(sequence, stored, indices[i]);
    });
    on_frames(static_cast<int>(end - begin));
  }
  return clip;
}

InspectedWindow::InspectedWindow(const Sequence& sequence, const InspectedClip& clip)
    : sequence_(sequence), stored_(AsStored(sequence)), clip_(clip) {}

const InspectedFrame& InspectedWindow::At(int index) {
  const auto is_it = [&](const InspectedFrame& frame) { return frame.index == index; };
  const auto kept = std::find_if(clip_.frames.begin(), clip_.frames.end(), is_it);
  if (kept != clip_.frames.end()) return *kept;
  const auto loaded = std::find_if(loaded_.begin(), loaded_.end(), is_it);
  if (loaded != loaded_.end()) return *loaded;
  constexpr std::size_t kMost = 4;
  if (loaded_.size() == kMost) loaded_.pop_front();
  return loaded_.emplace_back(LoadInspected(sequence_, stored_, index));
}

Image DisplayLuma(const Image& color, bool linear) {
  Image luma(color.width, color.height, 1);
  const ColorEncoding encoding = linear ? ColorEncoding::kLinearHdr : ColorEncoding::kDisplay;
  for (std::size_t i = 0; i < luma.data.size(); ++i) {
    float rgb[3] = {color.data[3 * i], color.data[3 * i + 1], color.data[3 * i + 2]};
    ToDisplay(encoding, rgb);
    luma.data[i] = 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2];
  }
  return luma;
}

Image Smoothed(const Image& luma) {
  Image rows(luma.width, luma.height, 1), smooth(luma.width, luma.height, 1);
  for (int y = 0; y < luma.height; ++y) {
    for (int x = 0; x < luma.width; ++x) {
      const float left = luma.at(std::max(x - 1, 0), y);
      const float right = luma.at(std::min(x + 1, luma.width - 1), y);
      rows.at(x, y) = 0.25F * left + 0.5F * luma.at(x, y) + 0.25F * right;
    }
  }
  for (int y = 0; y < luma.height; ++y) {
    const float* above = &rows.data[rows.Index(0, std::max(y - 1, 0))];
    const float* here = &rows.data[rows.Index(0, y)];
    const float* below = &rows.data[rows.Index(0, std::min(y + 1, luma.height - 1))];
    for (int x = 0; x < luma.width; ++x) {
      smooth.at(x, y) = 0.25F * above[x] + 0.5F * here[x] + 0.25F * below[x];
    }
  }
  return smooth;
}

float BilinearAt(const Image& image, double x, double y) {
  const double last_x = image.width - 1, last_y = image.height - 1;
  if (!(x >= 0 && y >= 0 && x <= last_x && y <= last_y)) {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const int i = std::min(static_cast<int>(x), std::max(image.width - 2, 0));
  const int j = std::min(static_cast<int>(y), std::max(image.height - 2, 0));
  const float fx = static_cast<float>(x - i), fy = static_cast<float>(y - j);
  const int i1 = std::min(i + 1, image.width - 1), j1 = std::min(j + 1, image.height - 1);
  const float top = image.at(i, j) + fx * (image.at(i1, j) - image.at(i, j));
  const float bottom = image.at(i, j1) + fx * (image.at(i1, j1) - image.at(i, j1));
  return top + fy * (bottom - top);
}

}  // namespace warplut
