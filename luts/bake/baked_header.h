// The C++ header of a baked table.
#pragma once

#include <string>

#include "luts/certificate/certificate.h"
#include "luts/fit/fit.h"
#include "luts/quantize/baked_table.h"

namespace warplut {

// The name of the TableView in the header, in namespace warplut::baked: k, then the fit's name in
// camel case, with _ kept between digits (warplut_x1_3 -> kWarplutX1_3).
std::string BakedConstant(const std::string& name);

// The text of NAME.h: banner, provenance and certificate as comments, then the values and their
// TableView.
std::string BakedHeader(const Fit& fit, const TableView& table, const Certificate& certificate);

}  // namespace warplut
