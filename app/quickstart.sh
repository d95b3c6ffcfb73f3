#!/bin/bash
# From a fresh Debian 12 machine to a purse-string suture on video: installs what is missing, builds the release preset, runs the
# scripted surgeon through the scene, and says where the video, the frames and the session file are.
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-purse_string}
out=out/$scene

third_party/install-packages.sh
launcher=()
command -v ccache >/dev/null 2>&1 && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
[ -f build/release/CMakeCache.txt ] || cmake --preset release -DHALSTED_TESTS=OFF -DHALSTED_BENCH=OFF "${launcher[@]}"
cmake --build --preset release -j "$(nproc)" --target halsted

halsted=build/release/halsted
mkdir -p "$out"
rm -f "$out/session.halsted" "$out"/frame_*.png

echo "Running the scripted surgeon (physics in lockstep, every frame rendered in software) ..."
# One run: video, a handful of frames, and the session that produced them.
"$halsted" capture "scenes/$scene/expert.toml" --record "$out/session.halsted" --report "$out/report.html" \
  --video "$out/$scene.mp4" --fps 25 --size 1280x720 --out "$out" --at 2,10,30,60,90,98

echo "Checking that the recorded session replays to the same bits ..."
"$halsted" replay "$out/session.halsted" --verify

echo
echo "Done. What you have now:"
echo "  video    $out/$scene.mp4"
for frame in "$out"/frame_*.png; do echo "  frame    $frame"; done
echo "  session  $out/session.halsted   (replay it: $halsted replay $out/session.halsted --verify)"
echo "  report   $out/report.html"
echo "Next: $halsted train $scene   or   $halsted --help"
