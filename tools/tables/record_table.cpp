#include "tools/tables/record_table.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace warplut {

Cell TextCell(std::string text) { return {.value = text, .text = std::move(text)}; }

Cell NumberCell(double value, int digits) {
  return {.value = FiniteJson(value),
          .text = std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-"};
}

Cell SignedCell(double value, int digits) {
  Cell cell = NumberCell(value, digits);
  if (!std::isfinite(value)) return cell;
  const double unit = std::pow(10.0, -digits);
  const double rounded = std::round(value / unit) * unit;
  cell.text = rounded == 0 ? "0" : fmt::format("{:+.{}f}", rounded, digits);
  return cell;
}

Cell PsnrCell(double psnr) {
  return {.value = FiniteJson(psnr),
          .text = std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : "equal"};
}

Json FiniteJson(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace warplut
