#include "runtime/generation/frame_coefficients.h"

#include <algorithm>

#include "runtime/configuration/chosen.h"

namespace warplut::generation {
namespace {

// The largest coefficients that the build makes of displayed frames.
constexpr PixelFormat kLargestFormat =
    CoefficientFormat(kWarpedFrameFormat.value_or(PixelFormat::kRgba32F));

}  // namespace

FrameCoefficients::FrameCoefficients(const Prefilter& prefilter,
                                     const FrameGenerationOptions& options, int threads)
    : reference_(IsReference(options)),
      prefilter_(prefilter),
      pass_(std::make_unique<PrefilterPass>(prefilter, options.width, options.height, threads)) {
  const std::size_t row = static_cast<std::size_t>(options.width) * BytesPerPixel(kLargestFormat);
  for (Slot& slot : slots_) slot.rows = RowBuffer(row, options.height);
}

int FrameCoefficients::Find(std::uint64_t id) const {
  if (id == 0) return -1;
  return slots_[0].id == id ? 0 : slots_[1].id == id ? 1 : -1;
}

std::array<PrefilteredImage, 2> FrameCoefficients::OfBoth(const Source& frame0,
                                                          const Source& frame1,
                                                          Executor& executor) {
  int slot0 = Find(frame0.id), slot1 = Find(frame1.id);
  if (slot0 < 0) slot0 = slot1 < 0 ? 0 : 1 - slot1;
  if (slot1 < 0) slot1 = 1 - slot0;
  return {Fill(slots_[slot0], frame0, executor), Fill(slots_[slot1], frame1, executor)};
}

PrefilteredImage FrameCoefficients::Of(const Source& frame, Executor& executor) {
  return Fill(slots_[std::max(0, Find(frame.id))], frame, executor);
}

PrefilteredImage FrameCoefficients::Fill(Slot& slot, const Source& frame, Executor& executor) {
  const ImageView& samples = frame.samples;
  const MutableImageView coefficients = {slot.rows.data(), samples.width, samples.height,
                                         slot.rows.stride(), CoefficientFormat(samples.format)};
  if (frame.id == 0 || slot.id != frame.id) {
    slot.id = frame.id;
    if (reference_) {
      PrefilterPass::Reference(prefilter_, samples, coefficients);
    } else {
      pass_->Apply(samples, executor, coefficients);
    }
  }
  return {samples, coefficients};
}

std::size_t FrameCoefficients::bytes() const {
  std::size_t bytes = pass_ != nullptr ? pass_->bytes() : 0;
  for (const Slot& slot : slots_) bytes += slot.rows.size();
  return bytes;
}

}  // namespace warplut::generation
