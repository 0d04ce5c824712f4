// The variants of pipelines that tell what content pays for: other filters in the place of the
// table, other parameters, passes left out, and methods to compare with.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/judge/sequence_judging.h"
#include "tools/pipeline.h"

namespace warplut {

enum class VariantKind { kShipped, kFilter, kParameterSet, kPass, kMethod };
constexpr const char* Name(VariantKind kind) {
  switch (kind) {
    case VariantKind::kShipped:
      return "shipped";
    case VariantKind::kFilter:
      return "filter";
    case VariantKind::kParameterSet:
      return "parameters";
    case VariantKind::kPass:
      return "pass";
    case VariantKind::kMethod:
      return "method";
  }
  return "";
}

struct PipelineVariant {
  JudgedRun run;
  VariantKind kind = VariantKind::kShipped;
  // The filter, the parameters, or the pass that is left out or made cheaper; else empty.
  std::string change = {};
  // The index of the variant that it is compared with, of the same list; its own of kShipped, and
  // of methods without one.
  std::size_t base = 0;
};

struct VariantOptions {
  std::vector<const MethodInfo*> methods;  // at least one
  std::vector<const MethodInfo*> beside;   // methods that are only compared with
  std::vector<std::string> against;        // filters (NamedWarp), names of methods, files of tables
  bool one_grid = false;                   // all sequences are rendered at scale 1
};

// What the entries of --against are; an Error names one that is nothing, or says that no method
// reads the filters. No file is opened.
void CheckAgainst(const VariantOptions& options);

// Variants of every method that has passes: the method as the arguments say, then
//   kFilter        with each filter or table, where the method warps by one
//   kParameterSet  with the built-in parameters and with the published ones (kPaperParameters),
//                  where the method reads parameters in which they differ from those in use
//   kPass          without each pass of Omissions() (tools/profile/omission.h) that it has.
//                  Filters, and all of super resolution, have their own rows and are no passes; the
//                  filter of the motion is none where frames are generated, as composed motion is
//                  filtered when it is loaded
// and kMethod for every other method, compared with the first of `methods` that makes frames of its
// kind.
class PipelineVariants {
 public:
  // `arguments` as for Pipeline. Errors as CheckAgainst and Pipeline.
  PipelineVariants(const VariantOptions& options, const PipelineArguments& arguments);

  const std::vector<PipelineVariant>& list() const { return variants_; }
  std::vector<JudgedRun> runs() const;

 private:
  class Maker;
  std::vector<std::unique_ptr<Pipeline>> filters_;  // the runs read their tables
  std::vector<PipelineVariant> variants_;
};

// Whether the two show frames of one kind, from inputs of one kind.
bool AreComparable(const MethodInfo& a, const MethodInfo& b);

}  // namespace warplut
