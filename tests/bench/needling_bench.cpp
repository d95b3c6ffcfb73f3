/// What a needle's step costs with surfaces of order 15: above the skin, pressing it, inside. Issue 5 asks for 50 us.
#include <benchmark/benchmark.h>

#include "tests/sim/needling/needling_rig.h"

namespace {

using halsted::testing::NeedlingRig;

void stepAt(benchmark::State& state, double depth) {   // [m]
  NeedlingRig rig({}, 15);
  rig.go(depth, 5e-3);
  const double z = rig.input.needle.pose.position.z();   // [m]
  int k = 0;
  for (auto _ : state) {
    rig.to(halsted::Vec3(0, 0, z + (++k % 2 ? 1e-6 : 0.0)));
    benchmark::DoNotOptimize(rig.out);
  }
}

void needleAboveTheSkin(benchmark::State& state) { stepAt(state, -1e-3); }
void needlePressingTheSkin(benchmark::State& state) { stepAt(state, 0.4e-3); }
void needleInMuscle(benchmark::State& state) { stepAt(state, 20e-3); }

/// The dearest step: the skin gives way, the deeper surfaces are met and their nets laid.
void needleEnters(benchmark::State& state) {
  NeedlingRig start({}, 15);
  start.go(0.5e-3, 5e-3);
  for (auto _ : state) {
    state.PauseTiming();
    NeedlingRig rig = start;
    state.ResumeTiming();
    rig.depth(0.6e-3);
    benchmark::DoNotOptimize(rig.out);
  }
}

BENCHMARK(needleAboveTheSkin);
BENCHMARK(needlePressingTheSkin);
BENCHMARK(needleInMuscle);
BENCHMARK(needleEnters);

}  // namespace
