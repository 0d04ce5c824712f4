#include "tools/profile/profile_content.h"

#include <fmt/format.h>

#include <algorithm>

#include "datasets/error.h"
#include "datasets/hash.h"
#include "tools/terminal/warning.h"
#include "train/ranks/ranks.h"

namespace warplut {

ProfileContent::ProfileContent(const ProfileRequest& request, const Pipeline& pipeline,
                               const MethodInfo& method)
    : request_(request), pipeline_(pipeline), method_(method) {
  for (const std::string& path : request.sequences) {
    sequences_.push_back(ReadSequenceFor(pipeline, path, {&method}));
    if (sequences_.back().color_space != sequences_.front().color_space) {
      throw Error(
          fmt::format("'{}' and '{}' have different colour spaces; a pipeline is profiled for one",
                      sequences_.front().name, sequences_.back().name));
    }
  }
}

ColorEncoding ProfileContent::encoding() const {
  return sequences_.front().color_space == ColorSpace::kLinear ? ColorEncoding::kLinearHdr
                                                               : ColorEncoding::kDisplay;
}

bool ProfileContent::OneGrid() const {
  return std::all_of(sequences_.begin(), sequences_.end(),
                     [](const Sequence& sequence) { return sequence.render == sequence.output; });
}

std::vector<ProfileClip> ProfileContent::Load(const std::string& frames) const {
  std::vector<FrameRange> ranges;
  std::vector<double> work;
  for (const Sequence& sequence : sequences_) {
    ranges.push_back(ParseFrames(frames, sequence));
    const double pixels = static_cast<double>(sequence.output.width) * sequence.output.height;
    work.push_back(pixels * ranges.back().count);
  }
  const std::vector<int> owners = BalancedOwners(work, Ranks::World().count());
  std::vector<ProfileClip> clips;
  for (std::size_t i = 0; i < sequences_.size(); ++i) {
    clips.push_back(LoadOne(sequences_[i], ranges[i], owners[i]));
  }
  return clips;
}

std::string ProfileContent::Identity() const {
  const PipelineArguments& a = request_.pipeline;
  std::string text = fmt::format("{} {} {} {} {} {} {} {} {} {}", pipeline_.filter_name(), a.lookup,
                                 a.params, a.frames, a.generated, a.motion_filter, a.history,
                                 a.texels, every(), request_.within);
  for (const float alpha : a.alphas) text += fmt::format(" {}", alpha);
  text += method_.name;
  for (const Sequence& sequence : sequences_) text += SequenceJson(sequence);
  return text;
}

std::vector<ProfiledSequence> ProfileContent::Names() const {
  std::vector<ProfiledSequence> names;
  for (const Sequence& sequence : sequences_) {
    names.push_back({.name = sequence.name,
                     .sha1 = Sha1OfFile(sequence.folder / Sequence::kManifest),
                     .has_reference = HasReference(sequence)});
  }
  return names;
}

ProfileClip ProfileContent::LoadOne(const Sequence& sequence, const FrameRange& range,
                                    int owner) const {
  ProfileClip clip;
  clip.has_reference = HasReference(sequence);
  clip.owner = owner;
  const Ranks& ranks = Ranks::World();
  if (ranks.rank() != owner && !ranks.IsRoot()) return clip;
  clip.input = pipeline_.Load(sequence, range, {&method_}, Streams::kNone, every(), true);
  if (method_.super_resolution) {
    // Without super resolution the rendered frames are shown, not the references.
    for (ClipFrame& frame : clip.input.frames) frame.reference = ImageBuffer();
  }
  const Streams truth = AvailableStreams(sequence) & kTruthStreams;
  clip.truth = LoadClip(sequence, range.first, range.count, truth);
  if (ranks.rank() == owner) WarnOfLimitedColor({&clip.input, &clip.truth});
  return clip;
}

bool ProfileContent::HasReference(const Sequence& sequence) const {
  const Streams available = AvailableStreams(sequence);
  return Contains(available, Streams::kReference) &&
         (method_.super_resolution || GeneratesFromReferences(available));
}

}  // namespace warplut
