// A baked table in memory, and the check that a table keeps the contract.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "luts/contract.h"

namespace warplut {

// Integers of a table format: weight = integer / 2^FractionBits(format), in [-2, 2). Of a whole
// window: 0 where the footprint has no tap.
using IntegerRow = Weights<std::int32_t>;

// Owns TableValues(footprint) stored weights. The alternatives are in the order of TableFormat; a
// half is kept as its bits.
class BakedTable {
 public:
  // Stores the footprint's taps of `rows` (kRows of them, each integer one that `format` can hold).
  BakedTable(TableFormat format, const std::vector<IntegerRow>& rows,
             const Prefilter& prefilter = {}, Footprint footprint = Footprint::k16);

  TableFormat format() const { return static_cast<TableFormat>(storage_.index()); }
  TableView view() const;

 private:
  std::variant<std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<std::int8_t>,
               std::vector<float>>
      storage_;
  Prefilter prefilter_;
  Footprint footprint_;
};

// Whether `format` can store the integer.
bool CanStore(TableFormat format, std::int32_t integer);

// The integers of the kRows rows. An Error names `name`, the node and the weight if a stored value
// is no integer of the format (a half or float off its grid, or not finite).
std::vector<IntegerRow> TableIntegers(const TableView& view, const std::string& name);

// The weights of an integer row.
Weights<double> RealRow(const IntegerRow& row, TableFormat format);

// Checks the contract: a valid prefilter, of 16 taps alone; every row sums to exactly 1; row (0, 0)
// belongs to the prefilter (without one it is the identity); and the zeros and equal weights of
// nodes with dx = 0 or dy = 0. An Error names `name`, the node, what was found
// (the sum, or the weight) and what was expected.
void CheckTable(const TableView& view, const std::string& name);

}  // namespace warplut
