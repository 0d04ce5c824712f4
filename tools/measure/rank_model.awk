# Fits the cost of ranks and predicts it (tools/measure/measure_ranks.sh). Input, one run a line:
#   WORK RANKS SHARE FRAMES RUNS PROCESSOR EXCHANGES BYTES QUICKEST
# WORK is calibrate or train; SHARE the part of the work that the busiest rank has; FRAMES those of
# all clips; RUNS of the pipeline, or evaluations; PROCESSOR seconds of the busiest rank outside
# exchanges; EXCHANGES of a rank with BYTES in all, the quickest of which took QUICKEST seconds.
# Fitted on one rank, by least squares: calibrate = start + FRAMES (load + run RUNS), train = start
# + run RUNS. Predicted: the same with the share of a rank.
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
  if (work == "train") { t[2] = share * runs; return 2 }
  t[2] = share * frames
  t[3] = share * frames * runs
  return 3
}

{ work[NR] = $1; ranks[NR] = $2; share[NR] = $3; frames[NR] = $4; runs[NR] = $5
  processor[NR] = $6; calls[NR] = $7; bytes[NR] = $8; quickest[NR] = $9 }

END {
  split("calibrate train", works, " ")
  for (w = 1; w <= 2; ++w) {
    name = works[w]
    split("", a)
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
    # An exchange: each rank sends once, along a tree.
    if (ranks[r] > 1 && quickest[r] > 0) {
      log_ranks = log(ranks[r]) / log(2)
      latency += quickest[r] / (ranks[r] * log_ranks)
      ++latencies
    }
  }
  if (latencies > 0) latency /= latencies
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
  load = fitted["calibrate", 2]
  run = fitted["calibrate", 3]
  print "| coefficient | value |"
  print "|---|---|"
  printf "| start of calibrate, s | %.3f |\n", start
  printf "| loading a frame, ms | %.2f |\n", 1000 * load
  printf "| a run of sr on a frame, with its judging, ms | %.2f |\n", 1000 * run
  printf "| start of train, with its images and validation, s | %.2f |\n", fitted["train", 1]
  printf "| an evaluation of train, ms | %.1f |\n", 1000 * fitted["train", 2]
  printf "| an exchange, ms times ranks times log2(ranks) | %.4f |\n", 1000 * latency
  # 500 clips of 100 frames, 100 runs; the busiest of 64 ranks has 8 clips.
  most = 800
  exchange = 100 * latency * 64 * 6
  printf "| 50,000 frames, 100 runs, 1 rank, h | %.2f |\n", (start + 50000 * (load + 100 * run)) / 3600
  printf "| 50,000 frames, 100 runs, 64 ranks, h | %.2f |\n", (start + most * (load + 100 * run) + exchange) / 3600
  printf "| the same, clips loaded for every run, h | %.2f |\n", (start + most * 100 * (load + run) + exchange) / 3600
  printf "| of them exchanges, s | %.2f |\n", exchange
}
