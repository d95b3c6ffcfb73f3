/// Cost of the simulation's kernels on one core. `bar` has 4080 particles and 16 200 tets, `wall` is a plate one cell thick, as many
/// particles as the purse-string scene's tissue (1224).
#include <benchmark/benchmark.h>

#include <algorithm>

#include "sim/constraints/distance.h"
#include "sim/constraints/volume.h"
#include "sim/tissue/tissue.h"

namespace halsted {
namespace {

TetMesh bar() { return blockMesh(135, 5, 4, Vec3(0.27, 0.01, 0.008)); }
TetMesh wall() { return blockMesh(33, 17, 1, Vec3(0.1, 0.055, 0.002)); }

std::vector<std::array<int, 2>> edges(const TetMesh& mesh) {
  std::vector<std::array<int, 2>> list;
  for (const auto& tet : mesh.tets)
    for (int a : tet)
      for (int b : tet)
        if (a < b) list.push_back({a, b});
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

Particles particlesOf(const TetMesh& mesh) {
  Particles particles;
  for (const Vec3& x : mesh.vertices) particles.push_back({x, x.x() == 0.0 ? 0.0 : 1e5});
  return particles;
}

/// Counts constraint projections a second: distance (every edge) and volume (every tet) of the bar, swept once per substep.
void projectDistanceAndVolume(benchmark::State& state) {
  const TetMesh mesh = bar();
  Particles particles = particlesOf(mesh);
  const DistanceConstraints distance = makeDistanceConstraints(edges(mesh), particles, 1e-4);
  const VolumeConstraints volume = makeVolumeConstraints(mesh.tets, particles, 1e-16);
  for (Particle& p : particles) p.position *= 1.01;
  for (auto _ : state) {
    project(distance, 1e-3, particles);
    project(volume, 1e-3, particles);
    benchmark::ClobberMemory();
  }
  const double sweep = size(distance) + size(volume);   // [1] projections
  state.counters["projections/s"] = benchmark::Counter(sweep * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["constraints"] = sweep;
}
BENCHMARK(projectDistanceAndVolume)->Unit(benchmark::kMicrosecond);

void tissueStep(benchmark::State& state, TissueSolver solver, LanePath path) {
  SimParams params;
  params.tissue.solver = solver;
  TetMesh mesh = wall();
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
    if (mesh.vertices[i].x() == 0.0) mesh.fixed.push_back(i);
  TissueModel model = buildTissue(mesh, params);
  model.xpbd.path = model.shape.path = path;
  TissueState tissue = restState(model);
  TissueWork work = prepareWork(model);
  const std::vector<Vec3> force(model.rest.size(), Vec3::Zero());
  for (auto _ : state) {
    predictTissue(model, force, tissue, work);
    finishTissue(model, tissue, work);
  }
  if (solver == TissueSolver::kShapeMatching) {
    const double iterations = model.shape.substeps * model.shape.iterations;   // [1]
    state.counters["s/iteration"] = benchmark::Counter(iterations * static_cast<double>(state.iterations()),
                                                       benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  }
  if (solver == TissueSolver::kXpbd) {
    state.counters["substeps"] = model.xpbd.substeps;
    state.counters["shortfall"] = model.xpbd.stiffnessShortfall;
  }
}
BENCHMARK_CAPTURE(tissueStep, projective, TissueSolver::kProjective, LanePath::kSerial)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tissueStep, xpbd_serial, TissueSolver::kXpbd, LanePath::kSerial)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tissueStep, xpbd, TissueSolver::kXpbd, widestLanes())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tissueStep, shape_matching_serial, TissueSolver::kShapeMatching, LanePath::kSerial)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(tissueStep, shape_matching, TissueSolver::kShapeMatching, widestLanes())->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace halsted
