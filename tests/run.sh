#!/bin/bash
# Installs what is missing, builds, runs the release suite and every reader's fuzz target for some seconds. The sweeps take longer and
# are named: the determinism test with another compiler, both sanitizers, longer fuzzing. Each part prints PASS or FAIL; the exit code
# is not zero when one failed.
#   tests/run.sh            the release suite but its longest scripts, and bounded fuzzing (from scratch: README)
#   tests/run.sh --sweeps   these and every sweep, bounded
#   tests/run.sh --full     longer sanitizer and fuzz sweeps
#   tests/run.sh --only P   one part of --sweeps: tests, fuzz, determinism, address or thread
set -uo pipefail
cd "$(dirname "$0")/.."

mode=suite
parts="tests fuzz"
case "${1:-}" in
  "") ;;
  --sweeps) mode=sweeps parts="tests fuzz determinism address thread" ;;
  --full) mode=full parts="tests fuzz determinism address thread" ;;
  --only) mode=sweeps parts=${2:-} ;;
esac
case "${1:-} $parts" in
  " "* | "--sweeps "* | "--full "* | "--only tests" | "--only fuzz" | "--only determinism" | "--only address" | "--only thread") ;;
  *) echo "usage: tests/run.sh [--sweeps | --full | --only tests|fuzz|determinism|address|thread]" >&2; exit 2 ;;
esac

jobs=$(nproc)
logs=build/logs
mkdir -p "$logs"
results=()
failed=0

# part NAME COMMAND...: runs it with its output in a log; shows the log's end when it failed.
part() {
  local name=$1 start=$SECONDS
  shift
  if "$@" >"$logs/$name.log" 2>&1; then
    results+=("PASS  $name  ($((SECONDS - start)) s)")
  else
    results+=("FAIL  $name  ($((SECONDS - start)) s, $logs/$name.log)")
    failed=1
    tail -n 60 "$logs/$name.log"
  fi
  echo "${results[-1]}"
}

launcher() { command -v ccache >/dev/null 2>&1 && echo "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"; return 0; }

build() {                                       # build PRESET [target...]
  local preset=$1
  shift
  local targets=()
  [ $# -gt 0 ] && targets=(--target "$@")
  # shellcheck disable=SC2046
  cmake --preset "$preset" $(launcher) >/dev/null && cmake --build --preset "$preset" -j "$jobs" "${targets[@]}"
}

release_suite() {
  local code=0
  local filter=(-LE usb)                        # the whole must stay under 25 minutes: these are left to the sweeps
  [ "$mode" = suite ] && filter+=(-E 'SlowAltemeier|SlowLembert|SlowConnell|SlowFriction')
  ctest --no-tests=error --test-dir build/release -j "$jobs" --output-on-failure "${filter[@]}" >"$logs/ctest.log" 2>&1 || code=$?
  # Emulated devices answer in real time: a computer busy elsewhere for 10 ms silences them, so these run alone and may be tried again.
  ctest --no-tests=error --test-dir build/release --output-on-failure -L usb --repeat until-pass:3 >>"$logs/ctest.log" 2>&1 || code=$?
  grep -vE '^ *[0-9]+/[0-9]+ Test .*Passed|^ +Start ' "$logs/ctest.log"
  return $code
}

# The golden hashes were written by gcc, optimised; clang without optimisation must reach the same bits.
other_compiler() {
  build clang halsted halsted_app_tests halsted_sim_tests &&
    ctest --no-tests=error --test-dir build/clang -j "$jobs" --output-on-failure -R 'Golden|Determinism|EveryBuild'
}

# Address and undefined-behaviour sanitizers over every folder's tests; the long-running ones only in the full mode.
address_sanitizer() {
  export ASAN_OPTIONS=detect_leaks=1:halt_on_error=1 LSAN_OPTIONS=suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
  build asan || return 1
  local filter=(-LE 'lint|usb')
  if [ "$mode" != full ]; then                  # without what takes long already in the release build
    filter=(-LE 'lint|usb' -E 'Golden|Slow|Window|Picture|InstrumentTie|KnotInTheStep|AssistKnot|ZWidth|Stability|StirredScene|FreshThread|WildHands|AbusedThread|NoEnergy|NoThrow|OfOthers|Installed')
    export HALSTED_ABUSE_STEPS=1000
  fi
  local code=0
  timeout 3600 ctest --no-tests=error --test-dir build/asan -j "$jobs" --output-on-failure "${filter[@]}" || code=$?
  ctest --no-tests=error --test-dir build/asan --output-on-failure -L usb || code=$?   # alone, as above, but not again: a fault of memory may come once
  return $code
}

# Thread sanitizer over the whole program in real time with virtual devices, the carriers, and the haptic code.
thread_sanitizer() {
  export TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1:suppressions=$PWD/tests/support/tsan.supp
  build tsan halsted halsted_app_tests halsted_haptics_tests halsted_hd_tests halsted_vendor_tests || return 1
  local filter=(-R 'TripleBuffer|SpscRing|Train|Haptic|HandLoop|^hd\.|^vendor\.' -E 'InstalledLibrary')
  [ "$mode" = full ] && filter=(-LE lint)
  timeout 3000 ctest --no-tests=error --test-dir build/tsan -j 1 --output-on-failure "${filter[@]}"
}

fuzz() {
  build fuzz halsted_fuzzers || return 1
  local seconds=3 target found=0
  [ "$mode" = sweeps ] && seconds=20
  [ "$mode" = full ] && seconds=300
  for target in build/fuzz/tests/fuzz_*; do
    [ -x "$target" ] && [ -f "$target" ] || continue
    found=1
    local reader=${target##*/fuzz_}
    local corpus=build/fuzz/corpus/$reader
    mkdir -p "$corpus"
    local seeds=()
    [ -d "tests/fuzz/seeds/$reader" ] && seeds=("tests/fuzz/seeds/$reader")
    "$target" -max_total_time=$seconds -timeout=10 -rss_limit_mb=2048 -artifact_prefix="$logs/fuzz-$reader-" \
      "$corpus" "${seeds[@]}" || return 1
  done
  [ $found -eq 1 ]
}

# The release build and its suite; nothing else is worth running when they fail to build.
build_and_test() {
  part build build release
  [ $failed -eq 0 ] || return 1
  local start=$SECONDS
  if release_suite; then
    results+=("PASS  tests  ($((SECONDS - start)) s)")
  else
    results+=("FAIL  tests  ($((SECONDS - start)) s, $logs/ctest.log)")
    failed=1
  fi
  echo "${results[-1]}"
  return 0
}

third_party/install-packages.sh || { echo "FAIL  install-packages"; exit 3; }
export HALSTED_SCENES=$PWD/scenes
for name in $parts; do
  case $name in
    tests) build_and_test || break ;;
    fuzz) part fuzz fuzz ;;
    determinism) part determinism-clang-debug other_compiler ;;
    address) part address-sanitizer address_sanitizer ;;
    thread) part thread-sanitizer thread_sanitizer ;;
  esac
done

echo
echo "== Summary =="
printf '%s\n' "${results[@]}"
[ -f "$logs/ctest.log" ] && grep -E 'tests passed|tests failed' "$logs/ctest.log"
[ $failed -eq 0 ] && echo "All parts passed." || echo "Something failed."
exit $failed
