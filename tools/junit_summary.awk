# Reads a report of 'ctest --output-junit'.
#   what=counts    prints 'PASSED FAILED SKIPPED'
#   what=details   prints the output of failed tests, and the reason of each skipped one
# A test whose program was not built has failed.
function attribute(name,   rest) {
  rest = $0
  if (!sub(".* " name "=\"", "", rest)) return ""
  sub("\".*", "", rest)
  return rest
}
function plain(text) {
  gsub("&lt;", "<", text); gsub("&gt;", ">", text); gsub("&quot;", "\"", text)
  gsub("&apos;", "'", text); gsub("&amp;", "\\&", text)
  return text
}
/<testcase / { test = plain(attribute("name")); state = attribute("status"); reason = ""; output = "" }
/<skipped / { if (attribute("message") != "SKIP_REGULAR_EXPRESSION_MATCHED") state = "fail" }
expect_reason { reason = plain($0); expect_reason = 0 }
/: Skipped$/ && state == "notrun" { expect_reason = 1 }
/<system-out>/ { in_output = 1 }
in_output {
  line = $0
  gsub("^.*<system-out>|</system-out>.*$", "", line)
  output = output "  " plain(line) "\n"
}
/<\/system-out>/ { in_output = 0 }
/<\/testcase>/ {
  if (state == "run") {
    passed++
  } else if (state == "fail") {
    failed++
    if (what == "details") printf "failed: %s\n%s", test, output
  } else {
    skipped++
    if (what == "details") printf "skipped: %s: %s\n", test, reason == "" ? state : reason
  }
}
END { if (what == "counts") print passed + 0, failed + 0, skipped + 0 }
