#include <algorithm>

#include "app/stress/series.h"
#include "app/stress/timed_run.h"
#include "app/stress/wall_points.h"

namespace halsted::app {
namespace {

constexpr double kDepth = 4e-3;                // [m] of a bite from the rim
constexpr double kDrawn = 0.01;                // [m/s] at which a loop is drawn shorter

double turnOf(int stitch) { return static_cast<double>(stitch) / kMostStressed; }   // [1]
double mirrored(double turn) { return 0.5 - turn; }            // [1] the same place seen from the other end: tops meet

/// Outside in at the left end, inside out at the right one.
bool laceStitch(const Model& m, double turn, State& s) {   // [1]
  const double across = mirrored(turn);        // [1]
  const TissuePoint holes[] = {wallPoint(m, 0, WallSide::kSerosa, turn, kDepth), wallPoint(m, 0, WallSide::kMucosa, turn, kDepth),
                               wallPoint(m, 1, WallSide::kMucosa, across, kDepth), wallPoint(m, 1, WallSide::kSerosa, across, kDepth)};
  double lies = 0.0;                           // [m]
  for (int i = 0; i < 4; ++i) lies += (pointOf(m, holes[(i + 1) % 4], s.tissue.position) - pointOf(m, holes[i], s.tissue.position)).norm();
  return tieStitch(m, s, holes, lies);
}

/// What hands do before they tie: the last loop is drawn until it is as long as both bites and both walls, edge to edge.
void draw(TimedRun& run, int steps) {
  const double enough = 2.0 * (2.0 * kDepth + run.model.params.anatomy.wall);   // [m]
  for (int k = 0; k < steps; ++k) {
    TiedStitches& all = *run.state.stitches;
    TiedStitch& last = all.stitch[all.count - 1];
    last.length = std::max(enough, last.length - kDrawn * run.model.params.dt);
    run.run(1);
  }
}

/// How far the edges stand apart at the stitches, at most.  [m]
double edgesApart(const TimedRun& run, int stitches) {
  double most = 0.0;                           // [m]
  for (int i = 0; i < stitches; ++i) {
    const double turn = turnOf(i);             // [1]
    const auto edge = [&](int bowel, double where) {                   // [1]
      return pointOf(run.model, wallPoint(run.model, bowel, WallSide::kSerosa, where, 0.0), run.state.tissue.position);
    };
    most = std::max(most, (edge(0, turn) - edge(1, mirrored(turn))).norm());
  }
  return most;
}

StressPoint look(TimedRun& run, int stitches) {
  StressPoint p = run.look(stitches, kTimedSteps);
  for (int k = 0; k < run.state.stitches->count; ++k) p.tension = std::max(p.tension, run.state.stitches->stitch[k].tension);
  p.torn = run.state.stitches->torn;
  p.gap = edgesApart(run, stitches);
  return p;
}

}  // namespace

StressSeries stressTwoBodies(Progress& progress) {
  const Scenario scenario = scenarioFromScene("connell", {"anatomy.gap=1e-3"}, {});
  const Model& m = scenario.model;
  StressSeries series{"two-bodies", "two bowel ends, rim to rim, joined by tied stitches one after the other round the ring", m.params.dt,
                      tissueParticles(m), static_cast<int>(m.mesh.tets.size()), threadNodes(m), {}};
  TimedRun run(m, scenario.start);
  run.state.stitches.emplace();
  run.run(kSettle);
  series.points.push_back(look(run, 0));
  for (int n = 1; n <= kMostStressed; ++n) {
    if (!laceStitch(m, turnOf(n - 1), run.state)) break;
    draw(run, kSettle);
    series.points.push_back(look(run, n));
    progress.show("two bodies, stitch " + std::to_string(n));
  }
  return series;
}

}  // namespace halsted::app
