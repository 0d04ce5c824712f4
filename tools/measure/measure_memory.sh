#!/bin/sh
# Measures the memory of calibrations on 10, 100 and 1,000 small clips, with and without a limit,
# and leaves the table of docs/results/cluster.md for tools/measure/update_tables.sh.
# usage: tools/measure/measure_memory.sh OUT
# The program is build/release/tools/warplut, or $WARPLUT. Needs GNU time.
set -eu

# shellcheck source=tools/measure/measuring.sh
. "$(dirname "$0")/measuring.sh"
table=$out/tables/memory.md
limit=512K
seconds=10 # of a search; each clip was loaded before

render_missing street "$out/small" --width 64 --height 36 --frames 2 --samples 2 \
  --streams color,depth,motion,reference
# Clips that share their images and differ by name.
copy() {
  clip=$out/clips/$1
  if [ -f "$clip/sequence.json" ]; then return; fi
  mkdir -p "$out/clips"
  cp -rl "$out/small/street" "$clip"
  rm "$clip/sequence.json"
  sed "s/\"name\": *\"street\"/\"name\": \"clip$1\"/" "$out/small/street/sequence.json" > "$clip/sequence.json"
}

# peak OPTION...: MiB that the calibration of the clips $1 to $2 held at most, and its runs.
peak() {
  /usr/bin/time -f %M -o "$out/memory.peak" "$warplut" calibrate --modes sr --filter catmull-rom --starts 0 \
    --fit blend_a --max-seconds "$seconds" --out "$out/memory.json" "$@" > "$out/memory.log" 2>&1 ||
    { cat "$out/memory.log" >&2; exit 1; }
  rm -f "$out/memory.json.checkpoint"
  awk '{ printf "%.1f", $1 / 1024 }' "$out/memory.peak"
}

echo "| clips | MiB with --memory $limit | MiB without |" > "$table.part"
echo "|---|---|---|" >> "$table.part"
for count in 10 100 1000; do
  set --
  i=0
  while [ "$i" -lt "$count" ]; do
    copy "$i"
    set -- "$@" "$out/clips/$i"
    i=$((i + 1))
  done
  echo "| $count | $(peak --memory "$limit" --sequence "$@") | $(peak --sequence "$@") |" >> "$table.part"
done
mv "$table.part" "$table"
cat "$table"
