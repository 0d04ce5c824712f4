#include "luts/certificate/certificate.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "luts/quantize/quantize.h"

namespace warplut {
namespace {

Loop MakeLoop(double gain, double blend) {
  return {gain, SafeWarps(gain), (1 - blend) * gain, gain > 1 ? 1 - 1 / gain : 0};
}

double Rounded(double value) {
  constexpr double kDecimals = 1e6;
  return std::round(value * kDecimals) / kDecimals + 0.0;
}

nlohmann::ordered_json LoopJson(const Loop& loop) {
  nlohmann::ordered_json json;
  json["gain"] = Rounded(loop.gain);
  if (loop.safe_warps) {
    json["safe_warps"] = *loop.safe_warps;
  } else {
    json["safe_warps"] = "unbounded";
  }
  json["closed_loop_gain"] = Rounded(loop.closed_loop_gain);
  json["smallest_blend"] = Rounded(loop.smallest_blend);
  return json;
}

}  // namespace

std::optional<std::int64_t> SafeWarps(double gain) {
  if (gain <= 1 + kUnitGainTolerance) return std::nullopt;
  auto warps = static_cast<std::int64_t>(std::log(kSafeGrowth) / std::log(gain));
  // The quotient may be off by rounding where gain^N is exactly kSafeGrowth.
  while (std::pow(gain, static_cast<double>(warps + 1)) <= kSafeGrowth) ++warps;
  while (std::pow(gain, static_cast<double>(warps)) > kSafeGrowth) --warps;
  return warps;
}

Stability CertifyStability(const TableView& table, double blend) {
  Stability s;
  s.blend = blend;
  s.gains = MapGains(table);
  s.any = MakeLoop(s.gains.nodes[s.gains.worst].gain, blend);
  s.half = MakeLoop(s.gains.nodes[RowIndex(kNodes / 2, kNodes / 2)].gain, blend);
  return s;
}

Certificate Certify(const Fit& fit, TableFormat format, double blend) {
  const BakedTable table = Quantize(SampleFit(fit, kNodes), format);
  return {CertifyStability(table.view(), blend), MeasureLookupErrors(fit)};
}

nlohmann::ordered_json ToJson(const Certificate& certificate) {
  const Stability& s = certificate.stability;
  const Gain& worst = s.gains.nodes[s.gains.worst];
  nlohmann::ordered_json json;
  json["safe_growth"] = kSafeGrowth;
  json["blend"] = s.blend;
  json["worst_node"] = {s.gains.worst % kNodes, s.gains.worst / kNodes};
  json["worst_frequency"] = {Rounded(worst.fx), Rounded(worst.fy)};
  json["any_offset"] = LoopJson(s.any);
  json["half_offset"] = LoopJson(s.half);
  nlohmann::ordered_json& errors = json["lookup_errors"] = nlohmann::ordered_json::array();
  for (const LookupError& e : certificate.lookup_errors) {
    errors.push_back({{"format", Name(e.format)},
                      {"lookup", Name(e.lookup)},
                      {"worst", Rounded(e.worst)},
                      {"mean", Rounded(e.mean)},
                      {"brightness", Rounded(e.brightness)}});
  }
  nlohmann::ordered_json& gains = json["node_gains"] = nlohmann::ordered_json::array();
  for (const Gain& g : s.gains.nodes) gains.push_back(Rounded(g.gain));
  return json;
}

}  // namespace warplut
