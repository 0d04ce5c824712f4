# Fits the cost of ranks and predicts it (tools/measure/measure_ranks.sh). Input, one run a line:
#   WORK RANKS SHARE FRAMES RUNS PROCESSOR EXCHANGES BYTES QUICKEST
# WORK is calibrate or train; SHARE the part of the work that the busiest rank has; FRAMES those of
# all clips; RUNS of the pipeline, or evaluations; PROCESSOR seconds of the busiest rank outside
# exchanges; EXCHANGES of a rank with BYTES in all, the quickest of which took QUICKEST seconds,
# which are there to be read: where ranks share cores they tell the scheduler's time.
# Fitted on one rank, by least squares: calibrate = start + run FRAMES RUNS, train = start + run RUNS.
# Predicted: the same with the share of a rank. Loading is part of the start: a third term for it is
# too small to be told from noise.
# Prints the predictions if part is 'predictions', else the coefficients and what follows.

# Solves the normal equations of n unknowns in a[1..n, 1..n + 1]; the result is in x.
function solve(a, n, x, i, j, k, factor) {
  for (i = 1; i <= n; ++i) {
    for (j = i + 1; j <= n; ++j) {
      factor = a[j, i] / a[i, i]
      for (k = i; k <= n + 1; ++k) a[j, k] -= factor * a[i, k]
    }
  }
  for (i = n; i >= 1; --i) {
    x[i] = a[i, n + 1]
    for (j = i + 1; j <= n; ++j) x[i] -= a[i, j] * x[j]
    x[i] /= a[i, i]
  }
}

# The terms of the model at a share of the work.
function terms(work, share, frames, runs, t) {
  t[1] = 1
  t[2] = share * runs * (work == "train" ? 1 : frames)
  return 2
}

{ work[NR] = $1; ranks[NR] = $2; share[NR] = $3; frames[NR] = $4; runs[NR] = $5
  processor[NR] = $6 }

END {
  split("calibrate train", works, " ")
  for (w = 1; w <= 2; ++w) {
    name = works[w]
    split("", a)
    n = 0
    for (r = 1; r <= NR; ++r) {
      if (work[r] != name || ranks[r] != 1) continue
      n = terms(name, share[r], frames[r], runs[r], t)
      # Relative errors count alike.
      for (i = 1; i <= n; ++i) {
        for (j = 1; j <= n; ++j) a[i, j] += t[i] * t[j] / processor[r] ^ 2
        a[i, n + 1] += t[i] * processor[r] / processor[r] ^ 2
      }
    }
    solve(a, n, x)
    for (i = 1; i <= n; ++i) fitted[name, i] = x[i]
  }
  for (r = 1; r <= NR; ++r) {
    n = terms(work[r], share[r], frames[r], runs[r], t)
    predicted[r] = 0
    for (i = 1; i <= n; ++i) predicted[r] += t[i] * fitted[work[r], i]
  }
  if (part == "predictions") {
    print "| work | ranks | frames | runs | predicted, s | measured, s | error |"
    print "|---|---|---|---|---|---|---|"
    for (r = 1; r <= NR; ++r) {
      printf "| %s | %d | %s | %d | %.2f | %.2f | %+.0f %% |\n", work[r], ranks[r],
        (frames[r] > 0 ? frames[r] : "-"), runs[r], predicted[r], processor[r],
        100 * (predicted[r] / processor[r] - 1)
    }
    exit
  }
  start = fitted["calibrate", 1]
  run = fitted["calibrate", 2]
  print "| coefficient | value |"
  print "|---|---|"
  printf "| start of calibrate, s | %.3f |\n", start
  printf "| a run of sr on a frame, with its judging, ms | %.2f |\n", 1000 * run
  if (fitted["train", 2] > 0) {
    printf "| start of train, with its images and validation, s | %.2f |\n", fitted["train", 1]
    printf "| an evaluation of train, ms | %.1f |\n", 1000 * fitted["train", 2]
  }
  # 500 clips of 100 frames, 100 runs; the busiest of 64 ranks has 8 clips.
  printf "| 50,000 such frames, 100 runs, 1 rank of one thread, h | %.2f |\n", (start + 50000 * 100 * run) / 3600
  printf "| the same, 64 ranks, without exchanges, h | %.2f |\n", (start + 800 * 100 * run) / 3600
}
