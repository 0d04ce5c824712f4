# Sourced by scripts that try commands on small inputs. Goes to a temporary folder, which is removed
# in the end, with the sequence input/street and the images images/courtyard. Sets work (that
# folder), root (of the project), warplut (the program: build/release/tools/warplut, or $WARPLUT) and
# lut.
# shellcheck shell=sh disable=SC2034 # what is set here is used by who sources it
cd "$(dirname "$0")/../.." || exit
root=$PWD
warplut=${WARPLUT:-$root/build/release/tools/warplut}
lut=$root/luts/baked/warplut_sr_x2.json
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
cd "$work" || exit

"$warplut" dataset render street --out input --width 64 --height 48 --frames 8 --samples 4 > /dev/null
"$warplut" dataset render courtyard --out images --width 256 --height 192 --frames 2 --samples 2 \
  --streams color,reference > /dev/null
