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

// Comment lines: what made the table, its prefilter and its certificate.
std::string HeaderBanner(const Fit& fit, const Certificate& certificate);

// The text of NAME.h: the banner, then the values, what is known of them as constants, and in C++20
// their TableView. In C++17 and C11 it includes nothing of this project.
std::string BakedHeader(const Fit& fit, const TableView& table, const Certificate& certificate);

}  // namespace warplut
