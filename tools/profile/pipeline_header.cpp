#include "tools/profile/pipeline_header.h"

#include <fmt/format.h>

#include <cctype>
#include <optional>

#include "runtime/configuration/choice_list.h"

namespace warplut {
namespace {

std::string Value(bool value) { return value ? "true" : "false"; }
std::string Value(const char* type, const std::string& name) {
  return fmt::format("{}::{}", type, Enumerator(name));
}
std::string Value(Filter value) { return Value("Filter", Info(value).name); }
std::string Value(Lookup value) { return Value("Lookup", Name(value)); }
std::string Value(HistoryForm value) { return Value("HistoryForm", Name(value)); }
std::string Value(ColorClamp value) { return Value("ColorClamp", Name(value)); }
std::string Value(DepthMeasure value) { return Value("DepthMeasure", Name(value)); }
std::string Value(MotionUpsampling value) { return Value("MotionUpsampling", Name(value)); }
std::string Value(CurrentFrame value) { return Value("CurrentFrame", Name(value)); }
std::string Value(PixelFormat value) { return Value("PixelFormat", Name(value)); }
std::string Value(MotionModel value) { return Value("MotionModel", Name(value)); }
std::string Value(DisocclusionFill value) { return Value("DisocclusionFill", Name(value)); }
std::string Value(ColorEncoding value) {
  return value == ColorEncoding::kDisplay ? "ColorEncoding::kDisplay" : "ColorEncoding::kLinearHdr";
}

// The lines of an initializer, one member each.
class Members {
 public:
  explicit Members(int indent) : indent_(static_cast<std::size_t>(indent), ' ') {}

  template <class T>
  void Add(const char* member, const std::optional<T>& choice) {
    if (choice) AddText(member, Value(*choice));
  }
  void Add(const char* member, bool value, bool default_value) {
    if (value != default_value) AddText(member, Value(value));
  }
  void AddText(const char* member, const std::string& value) {
    text_ += fmt::format("{}.{} = {},\n", indent_, member, value);
  }
  // "{...}" in lines of its own; nothing without members.
  void AddGroup(const char* member, const Members& group) {
    if (!group.text_.empty()) AddText(member, fmt::format("{{\n{}{}}}", group.text_, indent_));
  }

  const std::string& text() const { return text_; }

 private:
  std::string indent_;
  std::string text_;
};

constexpr int kIndent = 4;

template <class List, class Configuration>
Members MembersOf(const List& list, const Configuration& configuration) {
  Members members(2 * kIndent);
  ForEachChoice(list, [&](const auto& choice) {
    members.Add(choice.member, configuration.*choice.configured);
  });
  return members;
}

}  // namespace

std::string Enumerator(const std::string& name) {
  std::string enumerator = "k";
  bool upper = true;
  for (const char c : name) {
    if (c == '-' || c == ' ') {
      upper = true;
      continue;
    }
    const auto letter = static_cast<unsigned char>(c);
    enumerator += upper ? static_cast<char>(std::toupper(letter)) : c;
    // A letter after a digit begins a word: rgba16f.
    upper = std::isdigit(letter) != 0;
  }
  return enumerator;
}

std::string Initializer(const PipelineConfiguration& configuration) {
  const PipelineConfiguration defaults;
  Members members(kIndent);
  members.Add("super_resolution", configuration.super_resolution, defaults.super_resolution);
  members.Add("interpolation", configuration.interpolation, defaults.interpolation);
  members.Add("extrapolation", configuration.extrapolation, defaults.extrapolation);
  members.Add("reference", configuration.reference, defaults.reference);
  members.Add("peers", configuration.peers, defaults.peers);
  members.Add("filter", configuration.filter);
  members.Add("lookup", configuration.lookup);
  members.AddGroup("sr", MembersOf(kSrChoices, configuration.sr));
  members.AddGroup("generation", MembersOf(kGenerationChoices, configuration.generation));
  return fmt::format("{{\n{}}}", members.text());
}

std::string PipelineHeader(const std::vector<std::string>& banner,
                           const PipelineConfiguration& configuration) {
  std::string text;
  for (const std::string& line : banner)
    text += line.empty() ? "//\n" : fmt::format("// {}\n", line);
  return text +
         fmt::format(
             "// clang-format off\n#pragma once\n\n"
             "#include \"runtime/pipeline_configuration.h\"\n\n"
             "namespace warplut {{\n\ninline constexpr PipelineConfiguration kPipeline = {};\n\n"
             "}}  // namespace warplut\n",
             Initializer(configuration));
}

}  // namespace warplut
