# The scores of measure_claims.sh as one table: 'generated' chooses which methods.
BEGIN { split("recorded scenes", sets) }
{
  split($2, name, "/")
  kind = name[1] == "generated"
  if (kind != generated || (name[1] != "generated" && name[1] != "resolved")) next
  if (!(name[2] in seen)) { seen[name[2]] = 1; order[++count] = name[2] }
  psnr[$1, name[2]] = $3; ssim[$1, name[2]] = $4; ms[$1, name[2]] = $5
}
END {
  print "| method | recorded, PSNR dB | recorded, SSIM | ms/frame | scenes, PSNR dB | scenes, SSIM | ms/frame |"
  print "|---|---:|---:|---:|---:|---:|---:|"
  for (i = 1; i <= count; ++i) {
    row = "| " order[i] " |"
    for (s = 1; s <= 2; ++s) {
      key = sets[s] SUBSEP order[i]
      row = row (key in psnr ? " " psnr[key] " | " ssim[key] " | " ms[key] " |" : " - | - | - |")
    }
    print row
  }
}
