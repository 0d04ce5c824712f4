#!/bin/sh
# Installs what is missing, builds and runs every test. The last line is 'N passed, N failed, N
# skipped'. usage: tools/test.sh [--full | --sanitizers | --arm64]
#   --full         also builds the runtime alone and tests its core, tests what reads files and what
#                  a renderer calls under the sanitizers, and runs the fuzzers and clang-tidy on what
#                  changed if they are there: continuous integration
#   --sanitizers   instead builds and runs every test program under the sanitizers
#   --arm64        instead builds the runtime alone for 64-bit ARM and runs its tests in QEMU
# A build that fails counts as one failed test. Tests on recorded sequences run if WARPLUT_DATA
# names their folder.
set -eu
cd "$(dirname "$0")/.."

case "${1:-}" in
  '' | --full | --sanitizers | --arm64) what=${1:-} ;;
  *)
    echo "test.sh: '$1' is not an option; those are --full, --sanitizers and --arm64." >&2
    exit 1
    ;;
esac

jobs=$(nproc)
fuzz_seconds=15 # of each target
tidy_sources=6  # each takes half a minute
# All but the command line, which would compile the whole program once more.
fuzz_targets="fit image manifest motion packed_png parameters table_exr table_json"
# Tests of a smaller build that leaves them out, and those that the first build has run already.
elsewhere='_NOT_BUILT$|^Package\.|^Style\.|^Shaders\.'
passed=0
failed=0
skipped=0
started=$(date +%s)

# Whatever happens, the totals are the last line.
finish() {
  status=$?
  if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then failed=1; fi
  echo "$passed passed, $failed failed, $skipped skipped"
  if [ "$failed" -ne 0 ]; then exit 1; fi
}
trap finish EXIT
trap 'exit 1' INT TERM

step() { echo "== $* ($(($(date +%s) - started)) s)"; }

# configure_and_build PRESET [TARGET...]
configure_and_build() {
  preset=$1
  shift
  step "build $preset"
  log=build/$preset-configure.log
  mkdir -p build
  if ! cmake --preset "$preset" > "$log" 2>&1; then
    cat "$log"
    exit 1
  fi
  if [ $# -gt 0 ]; then set -- --target "$@"; fi
  cmake --build --preset "$preset" --parallel "$jobs" "$@" -- --quiet
}

# run_tests PRESET [CTEST OPTION...]: adds to the totals, prints why tests were skipped.
run_tests() {
  preset=$1
  shift
  step "test $preset"
  report=$PWD/build/$preset/junit.xml
  rm -f "$report"
  ctest --preset "$preset" --parallel "$jobs" --output-junit "$report" \
    --test-output-size-passed 10000000 --test-output-size-failed 10000000 "$@" \
    > "build/$preset/ctest.log" 2>&1 || true
  if [ ! -s "$report" ]; then
    tail -n 20 "build/$preset/ctest.log"
    exit 1
  fi
  awk -f tools/junit_summary.awk -v what=details "$report"
  read -r run_passed run_failed run_skipped <<END
$(awk -f tools/junit_summary.awk -v what=counts "$report")
END
  passed=$((passed + run_passed))
  failed=$((failed + run_failed))
  skipped=$((skipped + run_skipped))
}

# Whether clang++ is there and links with libFuzzer.
has_fuzzer() {
  command -v clang++ > /dev/null &&
    echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -fsanitize=fuzzer,address,undefined -x c++ - -o build/has_fuzzer 2> /dev/null
}

if [ "$what" = --arm64 ]; then
  tools/install_dependencies.sh --arm64
  configure_and_build runtime-arm64
  run_tests runtime-arm64
  step "done"
  exit
fi
tools/install_dependencies.sh
if [ "$what" = --sanitizers ]; then
  configure_and_build asan-ubsan
  run_tests asan-ubsan
  step "done"
  exit
fi
configure_and_build ci
run_tests ci
if [ "$what" = --full ]; then
  step "clang-tidy"
  if tools/tidy.sh HEAD~1 "$tidy_sources"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  configure_and_build runtime-only warplut_runtime chained_example test_contract test_runtime
  run_tests runtime-only --exclude-regex "$elsewhere"
  configure_and_build asan-ubsan test_compatibility test_datasets test_fuzz test_generation test_luts \
    test_peers test_runtime test_sr test_train_kernels
  run_tests asan-ubsan --exclude-regex "$elsewhere"
  if has_fuzzer; then
    step "fuzz"
    # shellcheck disable=SC2086 # a list of targets
    if tools/measure/fuzz.sh "$fuzz_seconds" $fuzz_targets; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  else
    echo "test.sh: there is no clang++ with libFuzzer; fuzzers are not run, only their corpora."
  fi
fi
step "done"
