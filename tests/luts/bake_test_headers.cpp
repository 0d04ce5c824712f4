// Bakes the headers that bake_test.cpp includes, into the folder given.
#include <exception>
#include <iostream>

#include "luts/bake/bake.h"
#include "test_fits.h"

int main(int argc, char** argv) try {
  using namespace warplut;
  if (argc != 2) {
    std::cerr << "usage: bake_test_headers FOLDER\n";
    return 1;
  }
  CreateFolder(argv[1]);
  for (const TableFormat format :
       {TableFormat::kI16, TableFormat::kF16, TableFormat::kI8, TableFormat::kF32}) {
    const Fit fit = MakeFit(0.2, 1, std::string("test_") + Name(format));
    WriteBaked(argv[1], Bake(fit, {format, kDefaultBlend}));
  }
  Fit wide = MakeFit(0, 1, "test_24");
  wide.footprint = Footprint::k24;
  wide.kaiser_b = 4.5;
  wide.parameters.assign(MlpParameters(wide.footprint), 0.0);
  WriteBaked(argv[1], Bake(wide));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
