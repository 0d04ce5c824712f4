#include "tools/payoff/pipeline_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "datasets/error.h"
#include "tools/judge/images/protocol_filter.h"
#include "tools/profile/omission.h"
#include "train/replay/parameters_file.h"

namespace warplut {
namespace {

// A method of this project with passes of its own.
bool HasPasses(const MethodInfo& method) { return !method.parameters.empty() && !method.peer; }

ModeRunOptions TemplateOf(const MethodInfo& method) {
  ModeRunOptions options;
  options.method = &method;
  return options;
}

bool WarpsByFilter(const MethodInfo& method) {
  return HasPasses(method) && ShippedPipeline(TemplateOf(method), false).Warps();
}

// The method that an entry of --against names, if it names no filter.
const MethodInfo* MethodNamed(const std::string& entry) {
  return NamedWarp(entry) ? nullptr : FindMethod(entry);
}

bool& MotionFilterOf(ProfiledPipeline& pipeline) {
  return pipeline.super_resolution ? pipeline.sr.motion_filter : pipeline.generation.motion_filter;
}

// Leaves the pass out of the pipeline that `options` make, and of the options; false where it is
// not a pass of it (PipelineVariants).
bool LeaveOut(const Omission& omission, bool one_grid, ModeRunOptions& options,
              ProfiledPipeline& pipeline) {
  pipeline = ShippedPipeline(options, one_grid);
  const bool super_resolution = pipeline.super_resolution;
  const Filter filter = pipeline.warp().filter;
  // Motion that is filtered only where it is quantised: a pass that may be left out, like one that
  // always runs.
  const bool sometimes = options.filter_quantised_motion && !MotionFilterOf(pipeline);
  if (sometimes) MotionFilterOf(pipeline) = true;
  const bool filtered = MotionFilterOf(pipeline);
  if (!omission.leave_out(pipeline)) return false;
  if (pipeline.super_resolution != super_resolution || pipeline.warp().filter != filter) {
    return false;
  }
  const bool filters = MotionFilterOf(pipeline);
  if (filtered && !filters) {
    if (Generates(*options.method)) return false;
    options.filter_quantised_motion = false;
  } else if (sometimes) {
    MotionFilterOf(pipeline) = false;
  }
  return true;
}

bool DifferInParametersOf(const MethodInfo& method, const Parameters& a, const Parameters& b) {
  return std::any_of(method.parameters.begin(), method.parameters.end(), [&](int index) {
    const auto member = kParameters[static_cast<std::size_t>(index)].member;
    return a.*member != b.*member;
  });
}

}  // namespace

bool AreComparable(const MethodInfo& a, const MethodInfo& b) {
  return a.super_resolution == b.super_resolution && Generates(a) == Generates(b);
}

void CheckAgainst(const VariantOptions& options) {
  const bool warps = std::any_of(options.methods.begin(), options.methods.end(),
                                 [](const MethodInfo* method) { return WarpsByFilter(*method); });
  for (const std::string& entry : options.against) {
    if (MethodNamed(entry) != nullptr) continue;
    if (!NamedWarp(entry) && !std::filesystem::exists(entry)) {
      throw Error(
          fmt::format("--against has '{}'; expected the file of a table, the name of a method, {}",
                      entry, WarpNames()));
    }
    if (!warps) {
      throw Error(fmt::format(
          "--against has the filter '{}' and no method that is judged warps by one; expected one "
          "that does, as sr or i",
          entry));
    }
  }
}

class PipelineVariants::Maker {
 public:
  Maker(const VariantOptions& options, const PipelineArguments& arguments, PipelineVariants& made)
      : options_(options), arguments_(arguments), made_(made), pipeline_(arguments) {
    if (!arguments.params.empty()) parameters_ = ReadParameters(arguments.params);
    for (const std::string& entry : options.against) {
      if (MethodNamed(entry) == nullptr) AddFilter(entry);
    }
  }

  void Make() {
    for (const MethodInfo* method : options_.methods) AddMethod(*method);
    for (const std::string& entry : options_.against) {
      if (const MethodInfo* method = MethodNamed(entry)) AddMethod(*method);
    }
    for (const MethodInfo* method : options_.beside) AddMethod(*method);
  }

 private:
  void AddFilter(const std::string& entry) {
    PipelineArguments arguments = arguments_;
    const bool named = NamedWarp(entry).has_value();
    arguments.filter = named ? entry : "";
    arguments.lut = named ? "" : entry;
    auto filter = std::make_unique<Pipeline>(arguments);
    const auto same = [&](const std::string& name) {
      return name == pipeline_.filter_name() ||
             std::find(names_.begin(), names_.end(), name) != names_.end();
    };
    std::string name = filter->filter_name();
    if (same(name)) name = entry;  // two tables of one name
    if (same(name) || entry == arguments_.lut) return;
    names_.push_back(std::move(name));
    made_.filters_.push_back(std::move(filter));
  }

  void AddMethod(const MethodInfo& method) {
    if (Find(method.name)) return;
    const auto asked = std::find(options_.methods.begin(), options_.methods.end(), &method);
    const std::size_t own = made_.variants_.size();
    if (asked == options_.methods.end() || !HasPasses(method)) {
      Add({.run = {.name = method.name, .method = &method},
           .kind = VariantKind::kMethod,
           .base = BaseOf(method).value_or(own)});
      return;
    }
    Add({.run = {.name = method.name, .method = &method},
         .kind = VariantKind::kShipped,
         .base = own});
    if (WarpsByFilter(method)) AddFilters(method, own);
    if (!method.paper) AddParameters(method, own);
    AddPasses(method, own);
  }

  void AddFilters(const MethodInfo& method, std::size_t base) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const Pipeline* filter = made_.filters_[i].get();
      const auto run = [filter](const Clip& clip, ModeRunOptions options, Executor& executor,
                                const ShownFrameSink& sink) {
        const ModeRunOptions other = filter->Options(*options.method, options.every);
        options.super_resolution.warp = other.super_resolution.warp;
        options.generation.warp = other.generation.warp;
        RunMode(clip, options, executor, sink);
      };
      Add({.run = {.name = fmt::format("{} with {}", method.name, names_[i]),
                   .method = &method,
                   .run = run},
           .kind = VariantKind::kFilter,
           .change = names_[i],
           .base = base});
    }
  }

  void AddParameters(const MethodInfo& method, std::size_t base) {
    const std::pair<const char*, Parameters> others[] = {
        {"built-in parameters", Parameters{}}, {"published parameters", kPaperParameters}};
    for (const auto& [name, parameters] : others) {
      if (!DifferInParametersOf(method, parameters, parameters_)) continue;
      const auto run = [other = parameters](const Clip& clip, ModeRunOptions options,
                                            Executor& executor, const ShownFrameSink& sink) {
        options.super_resolution.parameters = options.generation.parameters = other;
        RunMode(clip, options, executor, sink);
      };
      Add({.run = {.name = fmt::format("{} with {}", method.name, name),
                   .method = &method,
                   .run = run},
           .kind = VariantKind::kParameterSet,
           .change = name,
           .base = base});
    }
  }

  void AddPasses(const MethodInfo& method, std::size_t base) {
    const bool one_grid = options_.one_grid;
    for (const Omission& omission : Omissions()) {
      ModeRunOptions options = pipeline_.Options(method, 1);
      ProfiledPipeline pipeline;
      if (!LeaveOut(omission, one_grid, options, pipeline)) continue;
      const auto run = [&omission, one_grid](const Clip& clip, ModeRunOptions given,
                                             Executor& executor, const ShownFrameSink& sink) {
        ProfiledPipeline without;
        LeaveOut(omission, one_grid, given, without);
        RunPipeline(without, clip, given, executor, sink);
      };
      Add({.run = {.name = fmt::format("{} without {}", method.name, omission.name),
                   .method = &method,
                   .run = run,
                   .drawn = false},
           .kind = VariantKind::kPass,
           .change = omission.name,
           .base = base});
    }
  }

  void Add(PipelineVariant variant) { made_.variants_.push_back(std::move(variant)); }

  bool Find(const std::string& name) const {
    return std::any_of(made_.variants_.begin(), made_.variants_.end(),
                       [&](const PipelineVariant& one) { return one.run.name == name; });
  }

  // The first method that was asked for and makes frames of its kind.
  std::optional<std::size_t> BaseOf(const MethodInfo& method) const {
    for (std::size_t i = 0; i < made_.variants_.size(); ++i) {
      const PipelineVariant& one = made_.variants_[i];
      if (one.base == i && AreComparable(*one.run.method, method)) return i;
    }
    return std::nullopt;
  }

  const VariantOptions& options_;
  const PipelineArguments& arguments_;
  PipelineVariants& made_;
  const Pipeline pipeline_;
  Parameters parameters_;
  std::vector<std::string> names_;  // of the filters
};

PipelineVariants::PipelineVariants(const VariantOptions& options,
                                   const PipelineArguments& arguments) {
  CheckAgainst(options);
  Maker(options, arguments, *this).Make();
}

std::vector<JudgedRun> PipelineVariants::runs() const {
  std::vector<JudgedRun> runs;
  for (const PipelineVariant& variant : variants_) runs.push_back(variant.run);
  return runs;
}

}  // namespace warplut
