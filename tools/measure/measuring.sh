# Sourced by the scripts that measure: reads '[--data DIR] OUT' and goes to the root of the project.
# Sets data (recorded sequences, or nothing), out (an absolute path), warplut (the program); makes
# out/tables and out/params. The program is build/release/tools/warplut, or $WARPLUT. Defines
# render_missing.
# shellcheck shell=sh disable=SC2034 # what is set here is used by who sources it
data=${WARPLUT_DATA:-}
if [ "${1:-}" = --data ] && [ $# -ge 2 ]; then
  data=$2
  shift 2
fi
if [ $# -ne 1 ]; then
  echo "usage: tools/measure/$(basename "$0") [--data DIR] OUT" >&2
  exit 1
fi
mkdir -p "$1/tables" "$1/params"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.." || exit
warplut=${WARPLUT:-build/release/tools/warplut}

# render_missing SCENE FOLDER OPTION...: renders a built-in scene to FOLDER/SCENE, if it is not
# there.
render_missing() {
  scene=$1 folder=$2
  shift 2
  if [ ! -f "$folder/$scene/sequence.json" ]; then
    "$warplut" dataset render "$scene" --out "$folder" "$@" > /dev/null
  fi
}
