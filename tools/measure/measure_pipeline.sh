#!/bin/sh
# Measures the pipeline and leaves the tables of docs/results/{pipeline,speed}.md for
# tools/measure/update_tables.sh. usage: tools/measure/measure_pipeline.sh [--data DIR] OUT
#   --data DIR   recorded sequences: each is judged with parameters that were calibrated on the
#                others (default: $WARPLUT_DATA; without it only built-in scenes are measured)
#   OUT          sequences, parameters and pictures; the tables go to OUT/tables
# The program is build/release/tools/warplut, or $WARPLUT. Renderings that are there are not made
# again.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
lut=luts/baked/warplut_iir_x2.json

# without_times < FILE: tables of judge without their last column. Times are those of the benchmarks.
without_times() { sed -E '/^[|]/s/[^|]*[|]$//'; }

# judge OPTION...: the tables of warplut judge, without times.
judge() {
  "$warplut" judge --markdown "$@" > "$out/judged.md"
  without_times < "$out/judged.md"
}

# defaults TABLE OPTION...: judges the recorded sequences with the default parameters.
defaults() {
  table=$out/tables/$1.md
  shift
  judge --sequence "$data"/*/sequence.json --modes sr,i,isr --lut "$lut" "$@" > "$table.part"
  mv "$table.part" "$table"
}

# leave_one_out TABLE OPTION...: judges each recorded sequence with what the others ask for.
leave_one_out() {
  table=$out/tables/$1.md
  shift
  : > "$table.part"
  for judged in "$data"/*/sequence.json; do
    name=$(basename "$(dirname "$judged")")
    params=$out/params/$name.json
    set -- "$@" --
    for other in "$data"/*/sequence.json; do
      if [ "$other" != "$judged" ]; then set -- "$@" "$other"; fi
    done
    # What stands behind '--' are the sequences to fit.
    options=
    while [ "$1" != -- ]; do
      options="$options $1"
      shift
    done
    shift
    # shellcheck disable=SC2086 # the options have no spaces
    "$warplut" calibrate --sequence "$@" --modes sr,i,e --lut "$lut" --max-pixels 60000 \
      --starts 0 --out "$params" $options > "$params.txt"
    # shellcheck disable=SC2086
    "$warplut" judge --sequence "$judged" --modes sr,sr-paper,i,i-paper,e,isr,esr --lut "$lut" \
      --params "$params" --pictures "$out/pictures$(echo "$options" | tr -d ' ')" --markdown $options \
      > "$out/$name.txt"
    without_times < "$out/$name.txt" | sed '/\.png: /d' >> "$table.part"
    # shellcheck disable=SC2086
    set -- $options
  done
  mv "$table.part" "$table"
}

# scales TABLE: built-in scenes that nothing was fitted on, at factors that are not whole.
scales() {
  table=$out/tables/$1.md
  : > "$table.part"
  for scale in 1.5 1.7 3; do
    for scene in gallery harbour colonnade; do
      render_missing "$scene" "$out/scenes-x$scale" --scale "$scale" --width 714 --height 408 --frames 8
    done
    printf 'Factor %s:\n\n' "$scale" >> "$table.part"
    judge --sequence "$out/scenes-x$scale"/* --modes sr \
      --lut "luts/baked/warplut_iir_x$(echo "$scale" | tr . _).json" >> "$table.part"
  done
  mv "$table.part" "$table"
}

# hdr TABLE: built-in scenes that nothing was fitted on, as sRGB and as linear HDR, at the usual
# exposure and where much is above white.
hdr() {
  table=$out/tables/$1.md
  : > "$table.part"
  for exposure in 1 16; do
    for colour in srgb linear; do
      option=
      if [ "$colour" = linear ]; then option=--linear; fi
      for scene in gallery colonnade; do
        # shellcheck disable=SC2086 # no option is no word
        render_missing "$scene" "$out/scenes-$colour-$exposure" --exposure "$exposure" \
          --width 480 --height 270 --frames 8 $option
      done
      printf '%s, exposure %s:\n\n' "$colour" "$exposure" >> "$table.part"
      judge --sequence "$out/scenes-$colour-$exposure"/* --modes sr,i,e,isr --lut "$lut" \
        >> "$table.part"
    done
  done
  mv "$table.part" "$table"
}

# mean_sr FILTER OPTION...: 'PSNR | SSIM' of super resolution, the mean over the sequences of the
# options.
mean_sr() {
  filter=$1
  shift
  case "$filter" in
    warplut*) set -- --lut "luts/baked/$filter.json" "$@" ;;
    *) set -- --filter "$filter" "$@" ;;
  esac
  "$warplut" eval --modes sr --markdown "$@" \
    | awk -F ' *[|] *' '/^[|] mean/ { mean = 1 } mean && $2 == "sr" { print $3 " | " $4 }'
}

# filters TABLE: the same pipeline with different filters of the history, on scenes that nothing was
# fitted on and on recordings.
filters() {
  table=$out/tables/$1.md
  for scene in gallery harbour colonnade; do
    render_missing "$scene" "$out/scenes-filters" --width 480 --height 270 --frames 12
  done
  {
    printf '| filter of the history | scenes, PSNR dB | scenes, SSIM |'
    if [ -n "$data" ]; then printf ' recorded, PSNR dB | recorded, SSIM |'; fi
    printf '\n|---|---:|---:|'
    if [ -n "$data" ]; then printf -- '---:|---:|'; fi
    echo
    for filter in bilinear catmull-rom keys:-0.65 spline:0 spline:1/84 warplut_sr_x2 warplut_iir_x2; do
      printf '| %s | %s |' "$filter" "$(mean_sr "$filter" --sequence "$out/scenes-filters"/*)"
      if [ -n "$data" ]; then printf ' %s |' "$(mean_sr "$filter" --sequence "$data"/*/sequence.json)"; fi
      echo
    done
  } > "$table.part"
  mv "$table.part" "$table"
}

# bench TABLE SUBCOMMAND
bench() {
  code=0
  {
    echo '```'
    "$warplut" bench "$2" || code=$?
    echo '```'
  } > "$out/tables/$1.md"
  if [ "$code" -ne 0 ] && [ "$code" -ne 3 ]; then exit "$code"; fi
}

scales pipeline-scales
filters pipeline-filters
hdr pipeline-hdr
if [ -n "$data" ]; then
  leave_one_out pipeline-rendered
  leave_one_out pipeline-texels --texels
  defaults pipeline-defaults-rendered
  defaults pipeline-defaults-texels --texels
fi
bench bench-sr sr
bench bench-generation generation
