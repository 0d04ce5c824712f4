#!/bin/sh
# Runs each method for many frames without a cut and prints a table: growth of memory from the first
# tenth to the end, values of the last tenth, and the mean error of the second and of the last tenth.
# usage: tools/measure/soak.sh FRAMES
# The test is build/release/tests/soak/test_soak, or $WARPLUT_SOAK. Ends with 1 if memory or errors
# grow, or values leave [0, 1].
set -eu
cd "$(dirname "$0")/../.."

case "${1:-}" in
  '' | *[!0-9]*)
    echo "usage: tools/measure/soak.sh FRAMES, a whole number" >&2
    exit 1
    ;;
esac
log=$(mktemp)
trap 'rm -f "$log"' EXIT
status=0
WARPLUT_SOAK_FRAMES=$1 "${WARPLUT_SOAK:-build/release/tests/soak/test_soak}" > "$log" 2>&1 || status=1
echo "| method | frames | growth (KiB) | values | error of the second tenth | of the last tenth |"
echo "|---|---|---|---|---|---|"
grep '^|' "$log" || status=1
if [ "$status" -ne 0 ]; then grep -A 4 'Failure' "$log" >&2 || cat "$log" >&2; fi
exit "$status"
