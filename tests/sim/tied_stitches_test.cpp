/// Loops of thread that are tied and cut: what they pull with, what they leave alone, when they tear out, and that they replay.
#include "sim/suture/tied_stitches.h"

#include <gtest/gtest.h>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

/// The standing wall with tied stitches through points of it, given at rest.
struct StitchedWall : StepRig {
  explicit StitchedWall(const SimParams& p = wallParams()) : StepRig(p, kNeedleAway) { state.stitches.emplace(); }

  TissuePoint at(const Vec3& p) const { return tissuePointAt(model, p); }   // [m]
  /// Through both faces at two places of the wall, `apart` along it, tied `by` shorter than it lies.
  void tie(double y, double apart, double by, double z = 12.3e-3) {   // [m]
    const TissuePoint holes[] = {at({0.2e-3, y, z}), at({3.8e-3, y, z}), at({3.8e-3, y + apart, z}), at({0.2e-3, y + apart, z})};
    const double lies = 2.0 * (3.6e-3 + apart);                  // [m]
    ASSERT_TRUE(tieStitch(model, state, holes, lies - by));
  }
  const TiedStitch& stitch(int i = 0) const { return state.stitches->stitch[i]; }
  double length(int i = 0) const { return loopLength(model, stitch(i), state.tissue.position); }   // [m]
  Vec3 totalForce() const {                    // [N] of all stitches on the tissue
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < state.stitches->count; ++k)
      for (int i = 0; i < stitch(k).holeCount; ++i) sum += stitch(k).force[i];
    return sum;
  }
};

TEST(TiedStitches, ALoopThatFitsDoesNothing) {
  StitchedWall w;
  w.tie(8e-3, 6e-3, 0.0);
  w.run(200);
  EXPECT_LT(w.stitch().tension, 1e-9);
  EXPECT_LT(w.displacement(), 1e-9);
}

TEST(TiedStitches, ALooseLoopNeverPushes) {
  StitchedWall w;
  w.tie(8e-3, 6e-3, -5e-3);
  w.run(200);
  EXPECT_EQ(w.stitch().tension, 0.0);
  EXPECT_LT(w.displacement(), 1e-9);
}

/// At rest: tension = EA (L - L0) / L0, the same all the way round, and no net force or torque on the wall.
TEST(TiedStitches, ATightLoopObeysHookeAndBalances) {
  StitchedWall w;
  w.tie(8e-3, 6e-3, 2e-3);
  w.run(3000);
  const TiedStitch& s = w.stitch();
  const double strain = (w.length() - s.length) / s.length;      // [1]
  EXPECT_GT(s.tension, 0.1);
  EXPECT_NEAR(s.tension, w.model.params.thread.axialStiffness * strain, 1e-3 * s.tension);
  EXPECT_LT(strain, 1e-2);                     // thread hardly gives: the wall does
  EXPECT_LT(w.totalForce().norm(), 1e-12);
  EXPECT_LT(w.tissueSpeed(), 1e-5);
}

/// Two loops that share their tissue, each as if alone, come to rest too.
TEST(TiedStitches, NeighboursComeToRestTogether) {
  StitchedWall w;
  for (int i = 0; i < 12; ++i) w.tie(4e-3 + 1e-3 * i, 4e-3, 1.5e-3, 10.1e-3 + 0.3e-3 * (i % 2));
  w.run(4000);
  EXPECT_LT(w.tissueSpeed(), 1e-5);
  for (int i = 0; i < 12; ++i) {
    const double wanted = std::max(0.0, w.model.params.thread.axialStiffness * (w.length(i) / w.stitch(i).length - 1.0));   // [N]
    EXPECT_NEAR(w.stitch(i).tension, wanted, 1e-2 * wanted + 1e-4) << i;
  }
}

/// Two plates edge to edge, 1 mm apart, each held at its far side, and drawn together by a row of short loops across the gap: what bears them is stiff along
/// the loops and limp across them, as the rims of two bowels.
struct LacedPlates {
  Model model;
  State state;
  StepInput input;
  StepOutput out;

  static TetMesh mesh() {
    TetMesh all = blockMesh(1, 6, 8, Vec3(2e-3, 12e-3, 16e-3));
    const TetMesh other = all;
    const int first = static_cast<int>(all.vertices.size());
    for (const Vec3& v : other.vertices) all.vertices.push_back(v + Vec3(0.0, 13e-3, 0.0));
    for (const auto& t : other.tets) all.tets.push_back({t[0] + first, t[1] + first, t[2] + first, t[3] + first});
    for (int i = 0; i < static_cast<int>(all.vertices.size()); ++i)
      if (all.vertices[i].y() < 1e-9 || all.vertices[i].y() > 25e-3 - 1e-9) all.fixed.push_back(i);
    for (const Vec3& corner : {Vec3(0, 0, 16e-3), Vec3(2e-3, 0, 16e-3), Vec3(2e-3, 12e-3, 16e-3), Vec3(0, 12e-3, 16e-3)})
      for (int i = 0; i < first; ++i)
        if ((all.vertices[i] - corner).norm() < 1e-9) all.rim.push_back(i);
    return all;
  }
  LacedPlates() : model(buildModel(wallParams(), mesh(), {})), state(initialState(model, {kAway, kAway})) {
    for (ToolSample& tool : input.tools) tool.pose = kAway;
    state.stitches.emplace();
    for (int i = 0; i < 11; ++i) {
      const double z = 1.5e-3 + 1.3e-3 * i;      // [m]
      const TissuePoint holes[] = {tissuePointAt(model, {1e-3, 11.7e-3, z}), tissuePointAt(model, {1e-3, 13.3e-3, z})};
      EXPECT_TRUE(tieStitch(model, state, holes, 1.6e-3));       // they lie 3.2 mm round
    }
  }
  double speedAfter(int steps) {               // [m/s] the fastest particle
    for (int k = 0; k < steps; ++k) {
      for (ToolSample& tool : input.tools) ++tool.tick;
      step(model, input, state, out);
    }
    double most = 0.0;                         // [m/s]
    for (const Vec3& v : state.tissue.velocity) most = std::max(most, v.norm());
    return most;
  }
};

/// A row of loops swings as one, and the shorter their stretches are the more: each solved as if its neighbours stood still, rims were thrown past each
/// other to and fro, until holes tore.
TEST(TiedStitches, ARowOfShortLoopsComesToRest) {
  LacedPlates p;
  EXPECT_LT(p.speedAfter(3000), 1e-3);
  EXPECT_EQ(p.state.stitches->torn, 0);
  EXPECT_GT(p.state.stitches->stitch[5].tension, 0.03);
}

TEST(TiedStitches, PulledTooHardItTearsOut) {
  SimParams p = wallParams();
  p.needle.tearForce = 1.0;
  StitchedWall w(p);
  w.tie(8e-3, 6e-3, 4e-3);
  for (int k = 0; k < 500 && w.state.stitches->count > 0; ++k) w.step();
  EXPECT_EQ(w.state.stitches->count, 0);
  EXPECT_EQ(w.state.stitches->torn, 1);
  EXPECT_EQ(w.state.metrics.tears, 1);
  w.run(3000);
  EXPECT_LT(w.displacement(), 1e-4);           // the wall springs back
}

TEST(TiedStitches, AreHashedSavedAndRestored) {
  StitchedWall w;
  w.tie(8e-3, 6e-3, 2e-3);
  w.run(50);
  const std::vector<std::uint8_t> bytes = save(w.state);
  const std::uint64_t before = hash(w.state);
  State other = w.state;
  other.stitches->stitch[0].tension += 1e-12;
  EXPECT_NE(hash(other), before);
  std::string error;
  ASSERT_TRUE(load(bytes, other, error)) << error;
  EXPECT_EQ(hash(other), before);
}

TEST(TiedStitches, ThereIsRoomForSixtyFour) {
  StitchedWall w;
  const TissuePoint holes[] = {w.at({0.2e-3, 8e-3, 12.3e-3}), w.at({3.8e-3, 9e-3, 12.3e-3})};
  for (int i = 0; i < TiedStitches::kMost; ++i) ASSERT_TRUE(tieStitch(w.model, w.state, holes, 0.02));
  EXPECT_FALSE(tieStitch(w.model, w.state, holes, 0.02));
}

}  // namespace
}  // namespace halsted
