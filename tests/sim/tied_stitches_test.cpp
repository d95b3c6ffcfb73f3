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
