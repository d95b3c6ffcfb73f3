// What a frame costs. Run with LP_NUM_THREADS=0 to see the cost on one core.
#include <benchmark/benchmark.h>

#include "render/renderer.h"
#include "render/skin.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

/// One frame of a moving scene, 1280x720, read back. range(0): 0 the scene's camera, 1 close up.
void drawFrame(benchmark::State& state) {
  const RenderScene scene = syntheticScene();
  Renderer renderer(scene, 1280, 720);
  RenderSnapshot snapshot = syntheticSnapshot(scene, 0.9, 6);
  const CameraView camera = state.range(0) ? closeCamera() : scene.camera;
  double shift = 1e-4;                                   // [m]
  for (auto _ : state) {
    for (Vec3& p : snapshot.tissue) p.x() += shift;
    shift = -shift;
    benchmark::DoNotOptimize(renderer.draw(snapshot, HudInput{}, camera).rgba.data());
  }
  state.counters["frames_per_second"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(drawFrame)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->MinTime(3.0);

void followTissue(benchmark::State& state) {
  const RenderScene scene = syntheticScene();
  const Skin skin = buildSkin(scene.surface, scene.triangleLayer, scene.surfaceUv, scene.tissueRest.size(), 16000);
  SkinPose pose(skin);
  for (auto _ : state) {
    pose.update(skin, scene.tissueRest);
    benchmark::DoNotOptimize(pose.point(0));
  }
}
BENCHMARK(followTissue)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace halsted::render
