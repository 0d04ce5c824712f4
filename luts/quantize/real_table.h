// Weights on a grid of nodes, in double: a table before it is rounded.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "luts/contract.h"
#include "luts/fit/fit.h"

namespace warplut {

// Nodes at offsets i / intervals for i = 0..intervals in each axis, both ends included. A baked
// table has kNodes intervals (and leaves out its last nodes, which are the first ones of the next
// texel), the released layout kNodes - 1.
struct RealTable {
  std::string name;  // for error sentences
  int intervals = kNodes;
  std::vector<Weights<double>> rows;  // (intervals + 1)^2, dy slowest
  Prefilter prefilter = {};
  Footprint footprint = Footprint::k16;

  int RowAt(int ix, int jy) const { return jy * (intervals + 1) + ix; }
  const Weights<double>& Row(int ix, int jy) const { return rows[RowAt(ix, jy)]; }
};

using WeightFunction = std::function<Weights<double>(double dx, double dy)>;

// Evaluates `weights` at every node.
RealTable SampleWeights(const std::string& name, int intervals, const WeightFunction& weights);

// The head's weights of a valid fit at one offset.
Weights<double> FitWeights(const Fit& fit, double dx, double dy);

// The head's weights of a valid fit at every node, with its prefilter and footprint.
RealTable SampleFit(const Fit& fit, int intervals);

// The table on another grid, by cubic Lagrange interpolation of each weight in each axis on the
// four nearest nodes (the stencil stays inside the grid), then w + (1 - sum of w) B(d) with B the
// bilinear weights, so that rows sum to 1. Exact for weights that are bicubic in d, as those of
// Keys kernels are; nodes that both grids share are kept. The table needs at least 3 intervals.
RealTable Resample(const RealTable& table, int intervals);

// Adds (1 - sum of w) B(dx, dy) to w: the row then sums to 1 and keeps the zeros of the contract.
void CloseSum(Weights<double>* w, double dx, double dy);

// Whether the contract wants weight k of node (ix, jy) to be 0: at the first (last) node of an axis
// only the taps of the upper-left (lower-right) texel remain, with a prefilter also those beside
// it.
bool IsContractZero(bool prefiltered, int intervals, int ix, int jy, int k);

// The tap of an axis that must have the weight of `tap` at node i of it: with a prefilter the taps
// beside the texel of the first (last) node are alike; otherwise `tap` itself.
int MirroredTap(bool prefiltered, int intervals, int i, int tap);

// The largest difference between a weight and its image under one of the 8 symmetries of the
// square.
double Asymmetry(const RealTable& table);

}  // namespace warplut
