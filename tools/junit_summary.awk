# Reads a report of 'ctest --output-junit'.
#   what=counts    prints 'PASSED FAILED SKIPPED'
#   what=details   prints the output of failed tests, and the reason of each skipped one
# Where an entry is a suite of GoogleTest its tests are counted one by one, from what it printed. A
# test whose program was not built has failed, and so has one in which its program ended.
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
function count(test, state, output, reason) {
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
# A line that GoogleTest prints at the end of a test; the summary at its end tells no time.
function result_line(text) { return text ~ /^\[ +(OK|FAILED|SKIPPED) +\] .* \([0-9]+ ms\)$/ }
function test_of(text) {
  sub(/^\[[^\]]*\] /, "", text)
  sub(/ \([0-9]+ ms\)$/, "", text)
  return text
}
function read_line(text) {
  if (text ~ /^\[ RUN      \] /) { running = test_of(text); lines = ""; why = "" }
  if (result_line(text)) {
    results++
    if (text ~ /^\[ +OK/) count(test_of(text), "run", "", "")
    else if (text ~ /^\[ +FAILED/) { count(test_of(text), "fail", lines, ""); failures++ }
    else count(test_of(text), "notrun", "", why)
    running = ""
    return
  }
  if (expect_reason) { why = text; expect_reason = 0 }
  if (text ~ /: Skipped$/) expect_reason = 1
  lines = lines "  " text "\n"
}
/<testcase / {
  test = plain(attribute("name")); state = attribute("status")
  lines = ""; running = ""; why = ""; results = 0; failures = 0; expect_reason = 0
}
/<skipped / { if (attribute("message") != "SKIP_REGULAR_EXPRESSION_MATCHED") state = "fail" }
/<system-out>/ { in_output = 1 }
in_output {
  ended = sub("</system-out>.*$", "")
  sub("^.*<system-out>", "")
  read_line(plain($0))
  if (ended) in_output = 0
}
/<\/testcase>/ {
  if (results == 0) count(test, state, lines, why)
  else if (state == "fail" && failures == 0) count(running == "" ? test : running, "fail", lines, "")
}
END { if (what == "counts") print passed + 0, failed + 0, skipped + 0 }
