#!/bin/sh
# Runs one command of warplut on hosts that ssh reaches without a password.
# usage: tools/cluster/hosts.sh HOST[:RANKS],HOST[:RANKS]... train --data FOLDER --out FIT.json ...
# WARPLUT names the program: the same path on each host, as are all files of the command line.
set -eu

if [ $# -lt 2 ]; then
  echo "hosts.sh: expected a list of hosts and a command of warplut." >&2
  exit 1
fi
hosts=$1
shift

exec mpirun --host "$hosts" "${WARPLUT:-warplut}" "$@"
