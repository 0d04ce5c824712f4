// The C++ header of a baked table.
#pragma once

#include <string>

#include "luts/baked_table.h"
#include "luts/certificate.h"
#include "luts/fit.h"

namespace warplut {

// The text of NAME.h: banner, provenance and certificate as comments, then the values and their TableView.
std::string BakedHeader(const Fit& fit, const TableView& table, const Certificate& certificate);

}  // namespace warplut
