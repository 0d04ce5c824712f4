#!/bin/sh
#SBATCH --job-name=warplut
#SBATCH --ntasks=8
#SBATCH --cpus-per-task=4
# Runs one command of warplut on the ranks of a Slurm job.
# usage: sbatch tools/cluster/slurm.sh train --data FOLDER --out FIT.json ...
# WARPLUT names the program, RANKS their number outside Slurm.
set -eu

# Under Slurm, mpirun knows the hosts and the number of ranks of the job.
ranks=${SLURM_NTASKS:-${RANKS:-2}}
threads=${SLURM_CPUS_PER_TASK:-1}

exec mpirun -n "$ranks" --map-by "slot:PE=$threads" "${WARPLUT:-warplut}" "$@"
