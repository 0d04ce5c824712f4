#include "tools/inspection/sequence_inspection.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "datasets/error.h"

namespace warplut {
namespace {

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  double sum = 0;
  std::int64_t count = 0, infinite = 0;

  void Add(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
    ++count;
  }
};

// While it lives, libraries that write to standard error of what they refuse (libpng does, for each
// file) are not heard: the Error has the reason. For code that no other thread runs beside.
class QuietStandardError {
 public:
  QuietStandardError() : saved_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (saved_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  ~QuietStandardError() {
    if (saved_ < 0) return;
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  const int saved_;
};

constexpr Streams kEach[] = {
    Streams::kColor,          Streams::kDepth,           Streams::kMotion,   Streams::kReference,
    Streams::kReferenceDepth, Streams::kReferenceMotion, Streams::kReactive, Streams::kHud,
    Streams::kAlpha,          Streams::kReferenceAlpha};

const Image& StreamImage(const Frame& frame, Streams stream) {
  switch (stream) {
    case Streams::kDepth:
      return frame.depth;
    case Streams::kMotion:
      return frame.motion;
    case Streams::kReference:
      return frame.reference;
    case Streams::kReferenceDepth:
      return frame.reference_depth;
    case Streams::kReferenceMotion:
      return frame.reference_motion;
    case Streams::kReactive:
      return frame.reactive;
    case Streams::kHud:
      return frame.hud;
    case Streams::kAlpha:
      return frame.alpha;
    case Streams::kReferenceAlpha:
      return frame.reference_alpha;
    default:
      return frame.color;
  }
}

Frame LoadQuietly(const Sequence& sequence, int index, Streams stream) {
  const QuietStandardError quiet;
  return LoadFrame(sequence, index, stream);
}

void AddImage(const Image& image, Range& range) {
  if (image.channels == 2) {
    for (std::size_t i = 0; i < image.data.size(); i += 2) {
      range.Add(std::hypot(image.data[i], image.data[i + 1]));
    }
    return;
  }
  for (const float value : image.data) {
    if (std::isfinite(value)) {
      range.Add(value);
    } else {
      ++range.infinite;
    }
  }
}

}  // namespace

std::string ProblemText(const StreamInspection& stream) {
  if (stream.problems.empty()) return "";
  const std::size_t more = stream.problems.size() - 1;
  if (more == 0) return stream.problems.front();
  return fmt::format("{} ({} more {} of '{}' cannot be loaded)", stream.problems.front(), more,
                     more == 1 ? "frame" : "frames", stream.name);
}

Inspection InspectQuietly(const Sequence& sequence, const std::function<void()>& on_step,
                          bool faults) {
  const QuietStandardError quiet;
  return Inspect(sequence, on_step, faults);
}

std::vector<StreamInspection> InspectSequence(const Sequence& sequence,
                                              const std::function<void()>& on_load) {
  const Streams available = AvailableStreams(sequence);
  std::vector<StreamInspection> inspections;
  for (const Streams stream : kEach) {
    if (!Contains(available, stream)) continue;
    StreamInspection inspection;
    inspection.name = StreamNames(stream).front();
    Range range;
    for (int index = 0; index < sequence.count; ++index) {
      try {
        AddImage(StreamImage(LoadQuietly(sequence, index, stream), stream), range);
        ++inspection.frames;
      } catch (const Error& problem) {
        inspection.problems.emplace_back(problem.what());
      }
      on_load();
    }
    inspection.infinite = range.infinite;
    if (range.count > 0) {
      inspection.least = range.least;
      inspection.greatest = range.greatest;
      inspection.mean = range.sum / static_cast<double>(range.count);
    }
    inspections.push_back(std::move(inspection));
  }
  return inspections;
}

}  // namespace warplut
