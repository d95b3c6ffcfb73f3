#include <algorithm>
#include <cmath>

#include "app/stress/series.h"
#include "app/stress/timed_run.h"
#include "app/stress/wall_points.h"

namespace halsted::app {
namespace {

constexpr double kFirstDepth = 4e-3, kLastDepth = 16e-3;       // [m] of the bites from the rim
constexpr double kRounds = 3.0;                // [1] about the bowel: 7 mm from bite to bite, as surgeons space them
constexpr double kTail = 30e-3;                // [m] of thread before the first hole

struct Lacing {
  std::vector<TissuePoint> hole;
  std::vector<Vec3> path;                      // [m] from the tail's end through every hole to the swage
};

/// In and out along a spiral, at the first `bites` of fifty places; what is left of the thread leads straight away to the needle.
Lacing lacing(const Model& m, int bites) {
  Lacing l;
  for (int i = 0; i < bites; ++i) {
    const double share = static_cast<double>(i) / kMostStressed;       // [1]
    const double turn = kRounds * share - std::floor(kRounds * share), depth = kFirstDepth + share * (kLastDepth - kFirstDepth);   // [1] [m]
    const WallSide sides[] = {i % 2 ? WallSide::kMucosa : WallSide::kSerosa, i % 2 ? WallSide::kSerosa : WallSide::kMucosa};
    for (const WallSide side : sides) l.hole.push_back(wallPoint(m, 0, side, turn, depth));
  }
  const auto point = [&](std::size_t i) { return pointOf(m, l.hole[i], m.mesh.vertices); };
  const Vec3 outOfFirst = (point(0) - point(1)).normalized(), outOfLast = (point(l.hole.size() - 1) - point(l.hole.size() - 2)).normalized();
  const Vec3 clear = outOfLast + m.bowels.opening[0].axis;             // [1] out of the opening, away from the wall
  l.path.push_back(point(0) + kTail * outOfFirst);
  for (std::size_t i = 0; i < l.hole.size(); ++i) l.path.push_back(point(i));
  double used = 0.0;                           // [m]
  for (std::size_t i = 0; i + 1 < l.path.size(); ++i) used += (l.path[i + 1] - l.path[i]).norm();
  l.path.push_back(l.path.back() + (m.strand.length - used) * clear.normalized());
  return l;
}

void layThread(const Model& m, const Lacing& l, StrandState& s) {
  std::size_t leg = 0;
  double before = 0.0;                         // [m] of the path up to this leg
  for (int i = 0; i < m.strand.nodes; ++i) {
    while (leg + 2 < l.path.size() && m.strand.place[i] > before + (l.path[leg + 1] - l.path[leg]).norm()) {
      before += (l.path[leg + 1] - l.path[leg]).norm();
      ++leg;
    }
    s.position[i] = l.path[leg] + (m.strand.place[i] - before) * (l.path[leg + 1] - l.path[leg]).normalized();
  }
}

void openHoles(const Lacing& l, StrandState& s) {
  double coordinate = 0.0;                     // [m]
  for (std::size_t i = 0; i < l.hole.size(); ++i) {
    coordinate += (l.path[i + 1] - l.path[i]).norm();
    Hole& h = s.holes[i];
    h.tet = l.hole[i].tet;
    h.weight = l.hole[i].weight;
    h.coordinate = coordinate;
    h.bite = static_cast<std::int32_t>(i / 2);
    h.role = static_cast<std::int32_t>(i % 2 ? HoleRole::kPassed : HoleRole::kEntry);
  }
  s.holeCount = static_cast<std::int32_t>(l.hole.size());
  s.bitesBegun = s.holeCount / 2;
}

/// The driver holds the needle where the thread's path ends, its arc going on in the path's direction.
std::array<Pose, kHands> handsAt(const Model& m, const std::array<Pose, kHands>& start, const Lacing& l) {
  const Pose inTool = initialState(m, start).tools[kRight].needleInTool;
  Vec3 swage, tangent;
  arcAt(m.strand, m.strand.length, swage, tangent);
  const Vec3 along = (l.path.back() - l.path[l.path.size() - 2]).normalized();
  const Quat turn = turnOnto(tangent, along);
  const Pose needle{l.path.back() - turn * swage, turn};
  const Quat tool = (needle.orientation * inTool.orientation.conjugate()).normalized();
  return {start[kLeft], Pose{needle.position - tool * inTool.position, tool}};
}

StressPoint look(TimedRun& run, int bites) {
  StressPoint p = run.look(bites, kTimedSteps);
  for (const double t : run.state.strand.tension) p.tension = std::max(p.tension, t);
  p.torn = run.state.metrics.tears;
  return p;
}

}  // namespace

Scenario oneBodyScenario() { return scenarioFromScene("purse_string", {"thread.nodes=280"}, {}); }

StressPoint oneBodyWith(const Scenario& scenario, int bites) {
  const Model& m = scenario.model;
  if (bites == 0) {
    TimedRun empty(m, scenario.start);
    empty.run(kSettle);
    return look(empty, 0);
  }
  const Lacing l = lacing(m, bites);
  TimedRun run(m, handsAt(m, scenario.start, l));
  layThread(m, l, run.state.strand);
  openHoles(l, run.state.strand);
  run.run(kSettle);
  return look(run, bites);
}

StressSeries stressOneBody(Progress& progress) {
  const Scenario scenario = oneBodyScenario();
  const Model& m = scenario.model;
  StressSeries series{"one-body", "one open bowel end, one running thread in and out of its wall", m.params.dt,
                      tissueParticles(m), static_cast<int>(m.mesh.tets.size()), threadNodes(m), {}};
  for (int n = 0; n <= kMostStressed; ++n) {
    series.points.push_back(oneBodyWith(scenario, n));
    progress.show("one body, bite " + std::to_string(n));
  }
  return series;
}

}  // namespace halsted::app
