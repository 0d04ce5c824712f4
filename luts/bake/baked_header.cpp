#include "luts/bake/baked_header.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <iterator>
#include <string_view>

namespace warplut {
namespace {

using Out = std::back_insert_iterator<std::string>;

struct CppType {
  const char* name;
  const char* enumerator;
};

CppType TypeOf(TableFormat format) {
  switch (format) {
    case TableFormat::kI16:
      return {"std::int16_t", "kI16"};
    case TableFormat::kF16:
      return {"std::uint16_t", "kF16"};
    case TableFormat::kI8:
      return {"std::int8_t", "kI8"};
    case TableFormat::kF32:
      return {"float", "kF32"};
  }
  return {"", ""};
}

std::string Literal(const TableView& table, int index) {
  switch (table.format) {
    case TableFormat::kI16:
      return fmt::format("{}", static_cast<const std::int16_t*>(table.data)[index]);
    case TableFormat::kF16:
      return fmt::format("0x{:04x}", static_cast<const std::uint16_t*>(table.data)[index]);
    case TableFormat::kI8:
      return fmt::format("{}", static_cast<const std::int8_t*>(table.data)[index]);
    case TableFormat::kF32:
      return fmt::format("{:#}f", static_cast<const float*>(table.data)[index]);
  }
  return "";
}

void AppendProvenance(const Fit& fit, Out out) {
  fmt::format_to(
      out, "// Fit: scale {}, objective {}, optimizer {}, seed {}, horizons {}, gain bound {}.\n",
      fit.scale, fit.objective, fit.optimizer, fit.seed, fmt::join(fit.horizons, ", "),
      fit.gain_bound);
  if (fit.cut)
    fmt::format_to(out, "// A time limit ended the training before its work was done.\n");
  fmt::format_to(out,
                 "// Options: {}\n// Best Keys kernel on the same data: a = {}.\n// Data (sha1):\n",
                 fit.options, fit.keys_a);
  for (const FitData& d : fit.data) {
    fmt::format_to(out, "//   {} {} x {} {}\n", d.sha1, d.width, d.height, d.name);
  }
  fmt::format_to(out, "// Validation (mean SSIM):\n");
  for (const FitScore& s : fit.validation) {
    fmt::format_to(out, "//   {:<12} {:>4} warps, {:<6} offsets  {:.5f}\n", s.filter, s.warps,
                   s.offsets, s.ssim);
  }
}

// What a renderer runs on each image before the table reads it.
void AppendPrefilter(const Prefilter& p, Out out) {
  if (!HasPrefilter(p)) return;
  fmt::format_to(
      out,
      "// Prefilter: the table reads coefficients, which a separable pass over each image "
      "makes of its samples\n"
      "// (runtime/prefilter.h). Along rows, then along columns, images mirrored at their "
      "edges:\n");
  if (p.kind == PrefilterKind::kRecursive) {
    const double side = static_cast<double>(p.side);
    fmt::format_to(out,
                   "//   forward c+(i) = x(i) + z c+(i - 1), backward c(i) = z (c(i + 1) - c+(i)), "
                   "then c / s\n"
                   "//   with z = {:.8f}, s = {:.8f}\n",
                   PoleOfSide(side), side);
    return;
  }
  fmt::format_to(out,
                 "//   c(i) = t_0 x(i) + sum over j = 1..{} of t_j (x(i - j) + x(i + j)), t = {}\n",
                 p.reach, fmt::join(p.taps.begin(), p.taps.begin() + p.reach + 1, ", "));
}

// The initialiser of a Prefilter.
std::string PrefilterLiteral(const Prefilter& p) {
  if (p.kind == PrefilterKind::kRecursive) {
    return fmt::format("{{PrefilterKind::kRecursive, {:#}f, 0, {{}}}}", p.side);
  }
  std::string taps;
  for (int j = 0; j <= p.reach; ++j) taps += fmt::format("{}{:#}f", j > 0 ? ", " : "", p.taps[j]);
  return fmt::format("{{PrefilterKind::kFir, {:#}f, {}, {{{}}}}}", p.side, p.reach, taps);
}

void AppendLoop(const char* what, const Loop& loop, Out out) {
  fmt::format_to(out, "//   {:<14} {:.6f}   {:>10}   {:.6f}           {:.6f}\n", what, loop.gain,
                 loop.safe_warps ? fmt::format("{}", *loop.safe_warps) : "unbounded",
                 loop.closed_loop_gain, loop.smallest_blend);
}

void AppendCertificate(const Certificate& certificate, Out out) {
  const Stability& s = certificate.stability;
  fmt::format_to(out,
                 "// Certificate (growth of at most {}, blend {}; docs/CERTIFICATE.md):\n"
                 "//   offsets        gain       safe warps   closed-loop gain   smallest blend\n",
                 kSafeGrowth, s.blend);
  AppendLoop("any", s.any, out);
  AppendLoop("(1/2, 1/2)", s.half, out);
  fmt::format_to(out,
                 "//   worst node ({}, {})\n"
                 "// Weight error, summed over the taps, and brightness error:\n"
                 "//   format  lookup    worst     mean      brightness\n",
                 s.gains.worst % kNodes, s.gains.worst / kNodes);
  for (const LookupError& e : certificate.lookup_errors) {
    fmt::format_to(out, "//   {:<6}  {:<8}  {:.6f}  {:.6f}  {:.6f}\n", Name(e.format),
                   Name(e.lookup), e.worst, e.mean, e.brightness);
  }
}

// What a stored value means.
std::string Meaning(TableFormat format) {
  switch (format) {
    case TableFormat::kI16:
    case TableFormat::kI8:
      return fmt::format("weight = value / 2^{}", FractionBits(format));
    case TableFormat::kF16:
      return "each value the bits of a half";
    case TableFormat::kF32:
      return "each value a weight";
  }
  return "";
}

std::string FootprintConstant(Footprint footprint) {
  return fmt::format("Footprint::k{}", TapCount(footprint));
}

std::string TapsCheck(Footprint footprint) {
  return footprint == Footprint::k16 ? fmt::format("kTaps == {}", kTaps)
                                     : fmt::format("kWindowTaps == {}", kWindowTaps);
}

// What C++17 and C11 know of the table: they have no TableView.
void AppendConstants(const std::string& constant, const TableView& table, Out out) {
  const Prefilter& p = table.prefilter;
  fmt::format_to(out, "enum {{ {0}Nodes = {1}, {0}Taps = {2}, {0}FractionBits = {3} }};\n",
                 constant, kNodes, TapCount(table.footprint), FractionBits(table.format));
  if (p.kind == PrefilterKind::kRecursive) {
    fmt::format_to(out, "static const float {0}Side = {1:#}f, {0}Pole = {2:#}f;\n", constant,
                   p.side, static_cast<float>(PoleOfSide(p.side)));
  } else if (p.kind == PrefilterKind::kFir) {
    fmt::format_to(out, "static const float {}PrefilterTaps[{}] = {{", constant, p.reach + 1);
    for (int j = 0; j <= p.reach; ++j) fmt::format_to(out, "{}{:#}f", j > 0 ? ", " : "", p.taps[j]);
    fmt::format_to(out, "}};\n");
  }
}

void AppendValues(const std::string& constant, const TableView& table, Out out) {
  const CppType type = TypeOf(table.format);
  const int taps = TapCount(table.footprint);
  const std::string_view c_type =
      std::string_view(type.name).substr(std::string_view(type.name).starts_with("std::") ? 5 : 0);
  fmt::format_to(out,
                 "// {0} rows of {1}, one a line, dy slowest (luts/contract.h); {2}.\n"
                 "#ifdef __cplusplus\n"
                 "inline constexpr std::array<{3}, {4}> {5}Values = {{\n"
                 "#else\n"
                 "static const {6} {5}Values[{4}] = {{\n"
                 "#endif\n",
                 kRows, taps, Meaning(table.format), type.name, kRows * taps, constant, c_type);
  for (int row = 0; row < kRows; ++row) {
    fmt::format_to(out, "    ");
    for (int i = 0; i < taps; ++i) {
      fmt::format_to(out, "{}{}", Literal(table, row * taps + i), i + 1 < taps ? ", " : ",\n");
    }
  }
  fmt::format_to(out, "}};\n\n");
}

void AppendView(const std::string& constant, const TableView& table, Out out) {
  fmt::format_to(out,
                 "static_assert(kNodes == {} && {} && {}Values.size() == TableValues({}));\n\n"
                 "inline constexpr TableView {}{{TableFormat::{}, {}Values.data()",
                 kNodes, TapsCheck(table.footprint), constant, FootprintConstant(table.footprint),
                 constant, TypeOf(table.format).enumerator, constant);
  if (HasPrefilter(table.prefilter)) {
    fmt::format_to(out, ",\n                                    {}",
                   PrefilterLiteral(table.prefilter));
  }
  if (table.footprint != Footprint::k16) {
    fmt::format_to(out, ",\n                                    {{}}, {}",
                   FootprintConstant(table.footprint));
  }
  fmt::format_to(out, "}};\n");
}

}  // namespace

std::string BakedConstant(const std::string& name) {
  std::string constant = "k";
  bool capital = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool next_is_letter =
        i + 1 < name.size() && std::isalpha(static_cast<unsigned char>(name[i + 1]));
    if (c == '_' && next_is_letter) {
      capital = true;
      continue;
    }
    constant += static_cast<char>(capital ? std::toupper(c) : c);
    capital = false;
  }
  return constant;
}

std::string HeaderBanner(const Fit& fit, const Certificate& certificate) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "// Generated by warplut bake from fit {}, do not edit.\n//\n", fit.name);
  AppendProvenance(fit, out);
  AppendPrefilter(fit.prefilter, out);
  AppendCertificate(certificate, out);
  return text;
}

std::string BakedHeader(const Fit& fit, const TableView& table, const Certificate& certificate) {
  std::string text = HeaderBanner(fit, certificate);
  const Out out = std::back_inserter(text);
  const std::string constant = BakedConstant(fit.name);
  fmt::format_to(out,
                 "#pragma once\n\n"
                 "#ifdef __cplusplus\n"
                 "#include <array>\n"
                 "#include <cstdint>\n"
                 "#if __cplusplus >= 202002L || (defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)\n"
                 "#include \"luts/contract.h\"\n"
                 "#define WARPLUT_BAKED_VIEWS\n"
                 "#endif\n"
                 "namespace warplut::baked {{\n"
                 "#else\n"
                 "#include <stdint.h>\n"
                 "#endif\n\n");
  AppendConstants(constant, table, out);
  AppendValues(constant, table, out);
  fmt::format_to(out, "#ifdef WARPLUT_BAKED_VIEWS\n");
  AppendView(constant, table, out);
  fmt::format_to(out,
                 "#undef WARPLUT_BAKED_VIEWS\n"
                 "#endif\n\n"
                 "#ifdef __cplusplus\n"
                 "}}  // namespace warplut::baked\n"
                 "#endif\n");
  return text;
}

}  // namespace warplut
