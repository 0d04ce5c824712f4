#!/bin/sh
# Plots |H| of one warp by half a pixel along an axis, over frequency:
# docs/plots/resampler-gain.svg. usage: tools/measure/measure_gain_plot.sh Reads the table that
# ships, luts/baked/warplut_iir_x2.json; needs gnuplot. The closed forms are those of luts/filters.h
# at d = 1/2, where the weights of an axis are (o, 1/2 - o, 1/2 - o, o).
set -eu
cd "$(dirname "$0")/../.."
table=luts/baked/warplut_iir_x2.json
side=$(sed -n 's/.*"side": \([0-9.e-]*\).*/\1/p' "$table" | head -n 1)
# The outer weight of the node (1/2, 1/2): row 16 * 32 + 16 of the values, summed over the taps of
# the other axis.
outer=$(awk -F, '/"values": \[/ { at = NR } at && NR == at + 529 { print ($1 + $5 + $9 + $13) / 16384; exit }' "$table")
mkdir -p docs/plots
gnuplot << END
set terminal svg size 720, 420 font "sans,13" background "white"
set output "docs/plots/resampler-gain.svg"
set xlabel "frequency, cycles per pixel"
set ylabel "|H|"
set xrange [0:0.5]
set yrange [0:1.1]
set grid
set key bottom left
h(o, f) = abs(2 * (0.5 - o) * cos(pi * f) + 2 * o * cos(3 * pi * f))
p(s, f) = 1 / (1 - 2 * s + 2 * s * cos(2 * pi * f))
spline(k, f) = h(1.0 / 48 + k / 2, f) * p(1.0 / 6 + k, f)
plot h(-0.5 / 8, x) title "Catmull-Rom" lw 2, \\
  h(-0.58 / 8, x) title "Keys, a = -0.58" lw 2, \\
  spline(0, x) title "B-spline (k = 0)" lw 2, \\
  spline(1.0 / 84, x) title "spline, k = 1/84" lw 2, \\
  h($outer, x) * p($side, x) title "warplut\\\\_iir\\\\_x2" lw 2
END
echo "docs/plots/resampler-gain.svg"
