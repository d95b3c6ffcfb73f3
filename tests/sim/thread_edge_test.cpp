/// Thread over the free edge of a wall, its nodes farther apart than the wall is thick: what lies between them does not cut down into it, or is let out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/sim/cut_rig.h"
#include "tests/sim/knot_rig.h"
#include "tests/sim/wall_faces.h"

namespace halsted {
namespace {

constexpr double kEdgeSegment = 4.5e-3, kTight = 4.1e-3;   // [m] wider than the wall; as wide as the wall, not as it and the thread's radius on either side
constexpr int kEdgeNodes = 14;
constexpr double kEndPull = 0.4;                 // [N] at either end
constexpr int kOver = kEdgeNodes / 2;              // the node behind the edge

/// Thread hangs over the wall's top edge like a rope over a beam, both ends in jaws.
struct OverTheEdge : StepRig {
  explicit OverTheEdge(bool knots = true, double over = 0.5e-3) : StepRig(params(knots), kNeedleAway) {   // over [m] the edge, at first
    model.mesh.triangleLayer = wallFaces(model.mesh, model.surface);
    for (int i = 0; i < kEdgeNodes; ++i) {
      state.strand.position[i] = placeOf(i, over, model.params.thread.segmentLength);
      state.strand.nearVertex[i] = nearestVertex(model.surface, state.tissue.position, state.strand.position[i]);
    }
    state.strand.needle = KnotRig::needlePose(model.strand, state.strand.position);
    if (knots) {
      take(kLeft, 1);
      take(kRight, kEdgeNodes - 2);
    } else {
      letGo();
    }
  }
  /// Both hands go down alike until they feel in the mean what is asked, for so long.
  void draw(double seconds) {                  // [s]
    constexpr double kSpeed = 0.02, kFeel = 0.3;   // [m/s], [N]
    for (int k = 0; k < seconds / model.params.dt; ++k) {
      const double lack = (kEndPull - felt()) / kFeel;   // [1]
      for (ToolSample& t : input.tools) t.pose.position.z() -= std::clamp(lack, -1.0, 1.0) * kSpeed * model.params.dt;
      step();
      deepest = std::max(deepest, depth());
    }
  }
  double felt() const { return 0.5 * (state.tools[kLeft].threadForce.norm() + state.tools[kRight].threadForce.norm()); }   // [N]
  double deepest = -1.0;                       // [m] so far

  /// Below the surface, of the middle of a segment that goes from one side of the wall to the other.  [m]
  double depth() const {
    double most = -1.0;                        // [m]
    for (int i = 1; i < kEdgeNodes; ++i) {
      const Vec3 &a = state.strand.position[i - 1], &b = state.strand.position[i], middle = 0.5 * (a + b);
      if (a.x() > 0.0 || b.x() < kWallX) continue;
      int vertex = nearestVertex(model.surface, state.tissue.position, middle);
      const SurfacePoint near = nearestSurface(model.surface, state.tissue.position, middle, 8e-3, vertex);
      if (near.triangle >= 0) most = std::max(most, -near.distance);
    }
    return most;
  }

 private:
  static SimParams params(bool knots) {
    SimParams p = wallParams();
    p.thread.nodes = kEdgeNodes;
    p.thread.segmentLength = knots ? kEdgeSegment : kTight;
    p.thread.knots = knots;
    if (knots) p.contact.threadTissueFriction = 1.0;   // it does not slide over the edge
    return p;
  }
  static Vec3 placeOf(int node, double over, double segment) {   // [m]
    const double left = 0.5 * (kWallX - segment), top = kWallZ + over;
    const int below = node < kOver ? kOver - 1 - node : node - kOver;
    const double out = 0.1 * segment * below, down = std::sqrt(1.0 - 0.01) * segment * below;
    return Vec3(node < kOver ? left - out : left + segment + out, 0.5 * kWallY, top - down);
  }
  void letGo() {
    for (int hand = 0; hand < kHands; ++hand) {
      state.tools[hand].holdsNeedle = state.tools[hand].ratchet = state.tools[hand].closed = false;
      state.tools[hand].device = state.tools[hand].proxy = input.tools[hand].pose = kAway;
      input.tools[hand].jaw = 1.0;
    }
  }
  void take(int hand, int node) {
    ToolState& tool = state.tools[hand];
    tool.holdsNeedle = tool.ratchet = false;
    tool.threadCoordinate = model.strand.place[node];
    tool.closed = true;
    tool.jaw = input.tools[hand].jaw = 0.0;
    tool.device = tool.proxy = input.tools[hand].pose = frame(state.strand.position[node], Vec3::UnitY(), Vec3::UnitX());   // from below, jaws across the thread
  }
};

/// It lies at first with a node on either side of the wall, and may slide until one lies on the edge.
TEST(ThreadOverAnEdge, DoesNotCutDownIntoTheWall) {
  OverTheEdge rig;
  rig.draw(1.0);
  std::printf("drawn with %.2f N: at most %.2f mm below the edge\n", rig.felt(), 1e3 * rig.deepest);
  EXPECT_NEAR(rig.felt(), kEndPull, 0.1);
  EXPECT_LT(rig.deepest, 0.7e-3);
}

/// Thread that is not tied, and has cut in: its nodes on either side would pinch the wall between them for good.
TEST(ThreadOverAnEdge, WhatHasCutInIsLetOutOverTheEdge) {
  OverTheEdge rig(false, -1.4e-3);
  const double cut = rig.depth();              // [m]
  double pushed = 0.0;                         // [N]
  for (int k = 0; k < 500; ++k) {
    rig.step();
    for (int c = 0; c < rig.state.strand.contactCount; ++c) pushed = std::max(pushed, rig.state.strand.contacts[c].normalForce);
  }
  std::printf("%.2f mm below the edge, then %s; pushed with at most %.2f N\n", 1e3 * cut, rig.depth() < 0.0 ? "out of it" : "still in it", pushed);
  EXPECT_GT(cut, 1.2e-3);
  EXPECT_LT(rig.depth(), 0.5e-3);
  EXPECT_LT(pushed, 1.0);                      // taken out slowly
}

SimParams withFineThread(SimParams p, double segment) {   // [m]
  p.thread.nodes = 60;
  p.thread.segmentLength = segment;
  p.thread.knots = true;
  return p;
}

/// Fine thread that has sunk through the wall by its edge, straight across: it lies end on to both faces, its tail free on the far side.
struct SunkThread : StepRig {
  static constexpr double kFine = 1e-3, kSunk = 1e-3, kTail = 20e-3;   // [m] between nodes; below the edge; on the far side
  SunkThread() : StepRig(withFineThread(wallParams(), kFine), kNeedleAway) {
    for (int i = 0; i < model.strand.nodes; ++i) state.strand.position[i] = Vec3(kWallX + kTail - model.strand.place[i], 0.5 * kWallY, kWallZ - kSunk);
    state.strand.needle = KnotRig::needlePose(model.strand, state.strand.position);
    state.tools[kRight].holdsNeedle = state.tools[kRight].closed = false;
    input.tools[kRight].jaw = 1.0;
    ToolState& tool = state.tools[kLeft];
    const int node = static_cast<int>((kWallX + kTail) / kFine) + 10;
    tool.holdsNeedle = tool.ratchet = false;
    tool.threadCoordinate = model.strand.place[node];
    tool.closed = true;
    tool.jaw = input.tools[kLeft].jaw = 0.0;
    tool.device = tool.proxy = input.tools[kLeft].pose = frame(state.strand.position[node], Vec3::UnitY(), Vec3::UnitX());
  }
};

/// A push along it would hook it like a nail; it is drawn out, and over the edge on the way.
TEST(ThreadOverAnEdge, ThreadThatHasSunkThroughComesWithThePull) {
  SunkThread rig;
  constexpr double kSpeed = 0.02;              // [m/s]
  double most = 0.0;                           // [N]
  const double start = rig.state.strand.position[0].x();   // [m]
  for (int k = 0; k < 600; ++k) {
    rig.input.tools[kLeft].pose.position.x() -= kSpeed * rig.model.params.dt;
    rig.step();
    most = std::max(most, rig.state.tools[kLeft].threadForce.norm());
  }
  std::printf("drawn by 12 mm: the tail comes %.1f mm, at most %.2f N\n", 1e3 * (start - rig.state.strand.position[0].x()), most);
  EXPECT_GT(start - rig.state.strand.position[0].x(), 10e-3);
  EXPECT_LT(most, 0.3);
}

/// Thread that goes straight through a thin wall far below its edge, with no hole, both ends free: a node on either face, and a short tail behind it.
struct PiercingThread : StepRig {
  static constexpr double kThin = 2e-3, kTail = 20e-3;   // [m]
  PiercingThread(bool knots, double segment, double thin = kThin, double off = 0.0) : StepRig(params(knots, segment), kNeedleAway, kAway, thin) {   // [m]
    model.mesh.triangleLayer = wallFaces(model.mesh, model.surface, thin);
    if (knots) model.bowels.count = 2;         // such thread is drawn back between two bowels only
    for (int i = 0; i < model.strand.nodes; ++i) {
      state.strand.position[i] = Vec3(thin + kTail + off - model.strand.place[i], 0.5 * kWallY, 0.5 * kWallZ);
      state.strand.nearVertex[i] = nearestVertex(model.surface, state.tissue.position, state.strand.position[i]);
    }
    state.strand.needle = KnotRig::needlePose(model.strand, state.strand.position);
    state.tools[kRight].holdsNeedle = state.tools[kRight].closed = false;
    input.tools[kRight].jaw = 1.0;
  }
  static SimParams params(bool knots, double segment) {   // [m]
    SimParams p = wallParams();
    p.thread.segmentLength = segment;
    p.thread.knots = knots;
    return p;
  }
  /// Middles of segments deeper than the skin.
  int through() const {
    int count = 0;
    for (int i = 1; i < model.strand.nodes; ++i) {
      const Vec3 middle = 0.5 * (state.strand.position[i - 1] + state.strand.position[i]);
      int vertex = nearestVertex(model.surface, state.tissue.position, middle);
      count += nearestTriangle(model.surface, state.tissue.position, middle, vertex).distance < -0.3e-3;
    }
    return count;
  }
  double pushed() const {                      // [N] at most
    double most = 0.0;                         // [N]
    for (int c = 0; c < state.strand.contactCount; ++c) most = std::max(most, state.strand.contacts[c].normalForce);
    return most;
  }
};

/// Its nodes, pushed out on either side or left lying in the wall, pinched it or stayed in it for good.
TEST(PiercedWall, ThreadComesBackOutByItsNearerEnd) {
  for (const auto& [knots, segment] : {std::pair{false, 2e-3}, {true, 2e-3}, {true, 1.1e-3}, {true, 0.5e-3}}) {
    PiercingThread rig(knots, segment);
    ASSERT_GE(rig.through(), 1);
    double most = 0.0;                         // [N]
    int steps = 0;
    for (; steps < 2000 && rig.state.strand.position[0].x() > -1e-3; ++steps) {   // the tail, not the needle, comes through
      rig.step();
      most = std::max(most, rig.pushed());
    }
    std::printf("%s, nodes %.1f mm apart: out after %d steps, pushed with at most %.2f N\n", knots ? "meets itself" : "does not", 1e3 * segment, steps, most);
    EXPECT_LT(steps, 1000);
    rig.run(100);
    EXPECT_EQ(rig.through(), 0);
    EXPECT_LT(rig.pushed(), 0.1);
    EXPECT_LT(most, 0.5);                      // drawn, not thrown (40 N)
  }
}

/// Half-way between two nodes it may lie beside a wall that is thinner than they are apart: taken for thread that goes through none, it stayed.
TEST(PiercedWall, IsToldWhereverTheNodesLie) {
  for (const double off : {0.05e-3, 0.4e-3, 0.75e-3}) {          // [m] of a node from the far face
    PiercingThread rig(true, 2e-3, 1.2e-3, off);
    int steps = 0;
    while (steps < 1000 && rig.state.strand.position[0].x() > 0.0) { rig.step(); ++steps; }
    EXPECT_LT(steps, 1000) << off;
  }
}

/// Drawn thread cuts into soft folds; told by its depth alone it was let out as slowly, and buzzed (0.13 N a step over the gathered rim of `purse_string`).
TEST(PiercedWall, ThreadThatHasOnlyCutInIsPushedBackAtOnce) {
  constexpr double kCutIn = 1.2e-3;            // [m]
  constexpr int kNode = 6;
  PiercingThread rig(false, 2e-3);
  StrandState& s = rig.state.strand;
  for (int i = 0; i < rig.model.strand.nodes; ++i) {   // along the wall, outside it
    s.position[i] = Vec3(-2e-3, 0.5 * kWallY, kWallZ - 2e-3 - rig.model.strand.place[i]);
    s.nearVertex[i] = nearestVertex(rig.model.surface, rig.state.tissue.position, s.position[i]);
  }
  s.needle = KnotRig::needlePose(rig.model.strand, s.position);
  s.position[kNode].x() = kCutIn;              // nearer to the other face: it knows by which it went in
  rig.step();
  std::printf("from %.1f mm deep to %.2f mm\n", 1e3 * kCutIn, 1e3 * s.position[kNode].x());
  EXPECT_LT(s.position[kNode].x(), 0.5e-3);
}

/// Held on both sides of the wall, by jaws and by its needle, it has no way out but through the folds of a wall that it gathers: there it shook the rim.
TEST(PiercedWall, ThreadThatIsHeldOnBothSidesStaysUntilItIsLetGo) {
  PiercingThread rig(false, PiercingThread::kThin);
  constexpr int kHeld = 4;                     // node
  ToolState& tool = rig.state.tools[kLeft];
  tool.threadCoordinate = rig.model.strand.place[kHeld];
  tool.closed = true;
  tool.jaw = rig.input.tools[kLeft].jaw = 0.0;
  tool.device = tool.proxy = rig.input.tools[kLeft].pose = frame(rig.state.strand.position[kHeld], Vec3::UnitY(), Vec3::UnitX());
  rig.run(200);
  EXPECT_EQ(rig.through(), 1);
  EXPECT_GT(rig.state.strand.position[kHeld].x(), PiercingThread::kThin);
  rig.input.tools[kLeft].jaw = 1.0;
  rig.run(500);
  EXPECT_EQ(rig.through(), 0);
  EXPECT_LT(rig.pushed(), 0.1);
}

/// Thread thrown like an arrow at the top of a strip that can be cut, beside its edge.
struct Arrow : CutRig {
  static constexpr double kFine = 0.5e-3, kTop = kStripY * kCell;     // [m]
  explicit Arrow(double fromEdge) : CutRig(withFineThread(cutParams(), kFine)) {   // [m]
    StrandState& s = state.strand;
    for (int i = 0; i < model.strand.nodes; ++i) {
      s.position[i] = Vec3(fromEdge, kTop + 0.4e-3 + model.strand.place[i], 11e-3);
      s.velocity[i] = -2.0 * Vec3::UnitY();    // [m/s]
      s.nearVertex[i] = nearestVertex(model.surface, state.tissue.position, s.position[i]);
    }
    s.needle = KnotRig::needlePose(model.strand, s.position);
    s.needleVelocity = s.velocity[0];
    state.tools[kRight].holdsNeedle = state.tools[kRight].closed = false;
    input.tools[kRight].jaw = 1.0;
  }
};

/// It is stopped by the face that it meets. Let out across itself, as thread that has sunk through an edge is, it was thrown out of the side of the wall:
/// in `altemeier`, when a needle was let go that drew with 2.5 N, with 24 N in the thread, which broke.
TEST(ThreadOverAnEdge, ThreadThatFliesInEndOnIsStoppedByTheFaceThatItMeets) {
  for (const double fromEdge : {1.5e-3, 2.0e-3, 2.5e-3}) {
    Arrow rig(fromEdge);
    double aside = 0.0;                        // [m]
    for (int k = 0; k < 3; ++k) {
      rig.step();
      aside = std::max(aside, std::fabs(rig.state.strand.position[0].x() - fromEdge));
    }
    std::printf("%.1f mm from the edge: %.2f mm aside, tail at %.2f mm\n", 1e3 * fromEdge, 1e3 * aside, 1e3 * (rig.state.strand.position[0].y() - Arrow::kTop));
    EXPECT_LT(aside, 1e-3);
    EXPECT_GT(rig.state.strand.position[0].y(), Arrow::kTop - 0.5e-3);
  }
}

}  // namespace
}  // namespace halsted
