#!/bin/sh
# Builds the programs of programs/ as their authors would, against an installed copy and nothing else, and runs them on a hand that
# moves 30 mm to the right within half a second, presses both buttons one after the other and comes back.
#   run_programs.sh CMAKE BUILD_FOLDER TEST_FOLDER
set -eu
cmake=$1 build=$2 programs=$3/programs
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
prefix="$root/usr"
"$cmake" --install "$build" --component hd --prefix "$prefix" >"$root/install.log"
lib=$(dirname "$(find "$prefix" -name libHD.so)")
export LD_LIBRARY_PATH="$lib" HALSTED_HD_QUIET=1
cat >"$root/hand.csv" <<'EOF'
t_s,x_mm,y_mm,z_mm,buttons,inkwell
0,0,0,0,0,1
0.1,0,0,0,0,1
0.5,30,-5,0,0,0
0.6,30,-5,0,1,0
0.8,30,-5,0,0,0
0.9,30,-5,0,2,0
1.0,30,-5,0,0,0
1.4,-20,10,0,0,0
EOF

fail() { echo "FAIL: $1"; cat "$root/out" "$root/err"; exit 1; }
# runs a program and looks for lines in what it prints: expect STATUS 'regular expression' ... -- program arguments
expect() {
  status=$1; shift
  : >"$root/wanted"
  while [ "$1" != -- ]; do echo "$1" >>"$root/wanted"; shift; done
  shift
  got=0
  "$@" >"$root/out" 2>"$root/err" || got=$?
  [ "$got" -eq "$status" ] || fail "$1 ended with $got"
  while read -r line; do grep -qE "$line" "$root/out" || fail "$1 does not say: $line"; done <"$root/wanted"
  echo "ok: $(basename "$1")"
}

export HALSTED_HD_MOTION="$root/hand.csv"

"$cmake" -S "$programs/snapping" -B "$root/snapping" -DCMAKE_PREFIX_PATH="$prefix" >"$root/out" 2>"$root/err" || fail "find_package(OpenHaptics)"
"$cmake" --build "$root/snapping" >"$root/out" 2>"$root/err" || fail "snapping does not build"
expect 0 'made 1 lost 1 down 1 up 1 errors 0 data 7 strongest (0\.[4-9]|1)' 'gone 1$' '^plane 1 -15 t 0.5 back 1$' -- "$root/snapping/snapping"
OH_SDK_BASE=$prefix "$cmake" -S "$programs/snapping" -B "$root/base" >"$root/out" 2>"$root/err" || fail "find_package by OH_SDK_BASE"

g++ -std=c++11 -Wall -Wextra -I"$prefix/include" "$programs/omni_state.cc" -o "$root/omni_state" -L"$lib" -lHL -lHDU -lHD -lrt -lpthread
expect 0 '^Found Touch\.$' 'messages 160 events 4 locked force (0\.[1-9]|[12])' 'quaternion error (0|[0-9.]+e-(0[6-9]|1))' 'last x -?1' -- "$root/omni_state"

gcc -std=c11 -Wall -Wextra -I"$prefix/include" "$programs/touch_calibrate.c" -o "$root/touch_calibrate" -L"$lib" -lHDU -lHD -lm
expect 0 'Touch, serial HALSTED-VIRTUAL-1, firmware 1.000, HD 3.30.0' '^style inkwell$' 'waited 0' -- "$root/touch_calibrate"
expect 1 -- "$root/touch_calibrate" -d nosuch
printf '[[device]]\nname = "Default Device"\ncalibrated = false\ncalibration = "inkwell"\nmotion = "dock.csv"\n' >"$root/hd.toml"
printf 't_s,x_mm,y_mm,z_mm,inkwell\n0,0,0,0,0\n0.3,0,-65,-80,0\n0.4,0,-65,-80,1\n9,0,-65,-80,1\n' >"$root/dock.csv"
unset HALSTED_HD_MOTION
export HALSTED_HD_CONFIG="$root/hd.toml"
expect 0 '^please put the stylus' 'calibrated docked 1 waited 1 mean -?0.[0-9]* -65' -- "$root/touch_calibrate"
expect 2 '^gave up$' -- "$root/touch_calibrate" -s 0.1
unset HALSTED_HD_CONFIG
export HALSTED_HD_MOTION="$root/hand.csv"

gcc -std=c11 -Wall -Wextra -I"$prefix/include" "$programs/shape_demo.c" -o "$root/shape_demo" -L"$lib" -lHLU -lHL -lHDU -lHD -lm
expect 0 '^vendor Halsted \(HL is not provided\) context 0 shape 0 HL errors 5 device 1$' 'ticks 800 strongest [1-9.]+' 'error 0$' -- "$root/shape_demo"
grep -q 'HL Error: HL_INVALID_OPERATION' "$root/err" && grep -q 'haptic rendering' "$root/err" || fail "shape_demo: errors"

# One that cleans nothing up: its callback runs on while the process ends.
cat >"$root/careless.cc" <<'EOF'
#include <HD/hd.h>
#include <cstdio>
#include <string>
#include <vector>
static std::vector<std::string> log_of_ticks(1000, "a text that is long enough to live on the heap");
static HDCallbackCode HDCALLBACK forever(void *) {
  hdBeginFrame(hdGetCurrentDevice());
  hdEndFrame(hdGetCurrentDevice());
  return HD_CALLBACK_CONTINUE;
}
int main() {
  hdInitDevice(HD_DEFAULT_DEVICE);
  hdScheduleAsynchronous(forever, 0, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  while (hdGetSchedulerTimeStamp() == 0.0) {}
  std::puts("left running");
}
EOF
g++ -std=c++11 -I"$prefix/include" "$root/careless.cc" -o "$root/careless" -L"$lib" -lHDU -lHD
for time in 1 2 3 4 5; do expect 0 '^left running$' -- "$root/careless"; done

if command -v python3 >/dev/null; then
  expect 0 '^rows [0-9]+ reach (29|3[0-9])\.[0-9] presses 2 rate ok$' -- python3 "$programs/touch_logger.py" "$lib/libHD.so" 1.3 "$root/log.csv"
  [ "$(wc -l <"$root/log.csv")" -gt 500 ] || fail "the log is short"
else
  echo "SKIPPED: python3 is not installed"
fi
