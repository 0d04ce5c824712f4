# Makes the table 'gains' of README.md from docs/results/resampling.md and docs/results/pipeline.md.
# A row whose numbers are not there is left out.
BEGIN { FS = " *[|] *" }
/^<!-- table: / { split($0, words, " "); table = words[3]; next }
/^<!-- end -->/ { table = ""; next }
table == "" || !/^\|/ { next }
/^\|[-:| ]+\|$/ { next }
!/[|] *[0-9.+-]+ *[|]/ { title = $2; for (i = 3; i < NF; ++i) column[i] = $i; next }
{
  for (i = 3; i < NF; ++i) {
    value[table, title, $2, column[i]] = $i
    if (table == "quickstart-held-out" && column[i] ~ /^24 /) { sum[$2] += $i; ++count[$2] }
  }
}
function mean24(name) { return count[name] ? sum[name] / count[name] : "" }
function row(text, without, with, digits,   number) {
  if (without == "" || with == "") return
  number = "%." digits "f"
  printf "| %s | " number " | " number " | %+." digits "f |\n", text, without, with, with - without
}
function recorded(method) { return value["pipeline-defaults-rendered", "mean", method, "PSNR dB"] }
function filtered(name) { return value["pipeline-filters", "filter of the history", name, "recorded, PSNR dB"] }
END {
  print "| | without | with warplut | gain |"
  print "|---|---:|---:|---:|"
  row("SSIM after 24 warps, against Catmull-Rom", mean24("catmull-rom"), mean24("warplut_iir_x2"), 3)
  row("SSIM after 24 warps, against the best closed form (spline)", mean24("spline:1/84"), mean24("warplut_iir_x2"), 3)
  row("PSNR of super resolution x2, against bilinear", recorded("bilinear"), recorded("sr"), 2)
  row("PSNR of super resolution x2, the table against Catmull-Rom",
      filtered("catmull-rom"), filtered("warplut_iir_x2"), 2)
  row("PSNR of frames between two, against their average", recorded("average"), recorded("i"), 2)
}
