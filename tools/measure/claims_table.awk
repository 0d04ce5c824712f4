# The claims of Mob-FGSR (table 2, section 5, supplement tables 1 and 2) beside the scores of
# measure_claims.sh, whose lines are 'SET NAME/METHOD PSNR SSIM MS'.
BEGIN { split("recorded scenes", sets) }
{ psnr[$1, $2] = $3; ssim[$1, $2] = $4; ms[$1, $2] = $5; has[$1] = 1 }

function value(kind, set_name, method) {
  return kind == "psnr" ? psnr[set_name, method] : kind == "ssim" ? ssim[set_name, method] : ms[set_name, method]
}

# Starts a row: the claim, and what the paper has.
function claim(text, theirs) {
  row = "| " text " | " theirs " |"
  verdict = ""
}
function cell(text, ok, set_name) {
  row = row " " text " |"
  if (text == "-") return
  verdicts = verdicts (verdicts == "" ? "" : ", ") set_name " " (ok ? "yes" : "no")
}
function finish() {
  print row " " verdicts " |"
  verdicts = ""
}

# A ranking: methods from the best down.
function ranking(text, theirs, kind, list,    n, m, s, i, ok, shown) {
  claim(text, theirs)
  n = split(list, m, " ")
  for (s = 1; s <= 2; ++s) {
    if (!has[sets[s]]) { cell("-"); continue }
    ok = 1
    shown = ""
    for (i = 1; i <= n; ++i) {
      v = value(kind, sets[s], "generated/" m[i])
      if (i > 1) {
        holds = last + 0 > v + 0
        ok = ok && holds
        shown = shown (holds ? " > " : " **<** ")
      }
      shown = shown v
      last = v
    }
    cell(shown, ok, sets[s])
  }
  finish()
}

# a minus b, at least `least` and at most `most`.
function difference(text, theirs, kind, a, b, least, most,    s, d) {
  claim(text, theirs)
  for (s = 1; s <= 2; ++s) {
    if (!has[sets[s]]) { cell("-"); continue }
    d = value(kind, sets[s], a) - value(kind, sets[s], b)
    cell(sprintf(kind == "psnr" ? "%+.2f dB" : "%+.4f", d), d >= least && d <= most, sets[s])
  }
  finish()
}

# Time of a in times of b, at least `least`.
function ratio(text, theirs, a, b, least,    s, d) {
  claim(text, theirs)
  for (s = 1; s <= 2; ++s) {
    if (!has[sets[s]]) { cell("-"); continue }
    d = value("ms", sets[s], a) / value("ms", sets[s], b)
    cell(sprintf("%.1f times", d), d >= least, sets[s])
  }
  finish()
}

# a minus the best of the others.
function best(text, kind, a, list,    n, m, s, i, top, v) {
  claim(text, "-")
  n = split(list, m, " ")
  for (s = 1; s <= 2; ++s) {
    if (!has[sets[s]]) { cell("-"); continue }
    top = m[1]
    for (i = 2; i <= n; ++i) {
      if (value(kind, sets[s], m[i]) + 0 > value(kind, sets[s], top) + 0) top = m[i]
    }
    v = value(kind, sets[s], a) - value(kind, sets[s], top)
    sub(/.*\//, "", top)
    cell(sprintf(kind == "psnr" ? "%+.2f dB (%s)" : "%+.4f (%s)", v, top), v > 0, sets[s])
  }
  finish()
}

END {
  print "| claim | theirs | ours, recorded | ours, scenes | holds |"
  print "|---|---|---|---|---|"
  rivals = "generated/3dwarp generated/3dwarp-e generated/3dwarp-e-sheet generated/bidir generated/flow"
  far = 1000
  ranking("Ours-I > Ours-E > 3DWarp > BSR > AFME, PSNR (table 2)",
          "31.15 > 29.91 > 26.93 > 25.76 > 24.61", "psnr", "i-paper e-paper 3dwarp bidir flow")
  ranking("the same, SSIM", ".925 > .910 > .876 > .863 > .813", "ssim",
          "i-paper e-paper 3dwarp bidir flow")
  difference("Ours-I over 3DWarp, PSNR", "+4.22 dB", "psnr", "generated/i-paper", "generated/3dwarp", 4.22, far)
  difference("Ours-I over 3DWarp, SSIM", "+.049", "ssim", "generated/i-paper", "generated/3dwarp", .049, far)
  difference("accelerated over uniform motion, interpolation", "+.31, +.32 dB", "psnr",
             "generated/i-paper", "generated/i-paper-uniform", .3, far)
  difference("accelerated over uniform motion, extrapolation", "+.72, +.62 dB", "psnr",
             "generated/e-paper", "generated/e-paper-uniform", .6, far)
  difference("the LUT over bicubic in the loop, SSIM", "+.002", "ssim", "lut/sr-paper", "bicubic/sr-paper", .002, far)
  difference("the LUT over bilinear in the loop, SSIM", "+.026", "ssim", "lut/sr-paper", "bilinear/sr-paper", .026, far)
  difference("Ours-ISR is slightly below Ours-SR", "-.69 dB", "psnr", "joint/isr-paper", "resolved/sr-paper", -1, 0)
  difference("Ours-ESR is slightly below Ours-SR", "-1.79 dB", "psnr", "joint/esr-paper", "resolved/sr-paper", -2.1, 0)
  difference("FSR 2 is comparable to Ours-SR", "by eye", "psnr", "resolved/fsr2", "resolved/sr-paper", -.5, .5)
  ratio("3DWarp is slower than Ours-I", "10.9 times", "generated/3dwarp", "generated/i-paper", 1.5)
  ratio("BSR is slower than Ours-I", "1.4 times", "generated/bidir", "generated/i-paper", 1.2)
  best("i over the best other system that interpolates, PSNR", "psnr", "generated/i",
       "generated/3dwarp generated/bidir generated/flow")
  best("the same, SSIM", "ssim", "generated/i", "generated/3dwarp generated/bidir generated/flow")
  best("e over the best other system that extrapolates, PSNR", "psnr", "generated/e",
       "generated/3dwarp-e generated/3dwarp-e-sheet")
  best("the same, SSIM", "ssim", "generated/e", "generated/3dwarp-e generated/3dwarp-e-sheet")
  best("sr over the best peer, PSNR", "psnr", "resolved/sr", "resolved/taau resolved/sgsr2 resolved/fsr2")
  best("the same, SSIM", "ssim", "resolved/sr", "resolved/taau resolved/sgsr2 resolved/fsr2")
}
