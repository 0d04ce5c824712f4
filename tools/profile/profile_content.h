// The sequences of a profile and their clips.
#pragma once

#include <string>
#include <vector>

#include "tools/profile/pipeline_meter.h"
#include "tools/profile/profile_report.h"
#include "tools/profile/profile_request.h"

namespace warplut {

class ProfileContent {
 public:
  // Reads the manifests; request, pipeline and method outlive the object. Error: sequences of
  // different colour spaces, or as ReadSequenceFor.
  ProfileContent(const ProfileRequest& request, const Pipeline& pipeline, const MethodInfo& method);

  int every() const { return method_.generation == Generation::kNone ? 1 : request_.every; }

  ColorEncoding encoding() const;

  // Whether every sequence is rendered on its output grid.
  bool OneGrid() const;

  // The clips, each on the rank that runs it and on the root. `frames`: as on the command line.
  std::vector<ProfileClip> Load(const std::string& frames) const;

  // All that decides the scores, beside the contents of files.
  std::string Identity() const;

  std::vector<ProfiledSequence> Names() const;

 private:
  ProfileClip LoadOne(const Sequence& sequence, const FrameRange& range, int owner) const;

  // Whether the method's frames are on the grid of references.
  bool HasReference(const Sequence& sequence) const;

  const ProfileRequest& request_;
  const Pipeline& pipeline_;
  const MethodInfo& method_;
  std::vector<Sequence> sequences_;
};

}  // namespace warplut
