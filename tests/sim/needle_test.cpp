/// The needle against the wall through the whole step: dimple, puncture, passage, withdrawal.
#include <gtest/gtest.h>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr double kEntryY = 12.3e-3, kEntryZ = 9.2e-3;   // [m] where the tip meets the wall: on no vertex and no edge

/// Needle whose tip points along -x into the wall's face at x = 4 mm, `gap` before it, turned by `sine`, `cosine` about its centre.
Pose needlePose(const StrandModel& m, double gap, double angle) {   // gap [m], angle [rad]
  const double r = m.needle.radius;            // [m]
  const Vec3 centre(kWallX + gap, kEntryY, kEntryZ + r);
  const Vec3 x = std::cos(angle) * Vec3::UnitZ() + std::sin(angle) * Vec3::UnitX();
  const Vec3 y = std::cos(angle) * Vec3::UnitX() - std::sin(angle) * Vec3::UnitZ();
  return frame(centre, x, y);
}

struct Bite : StepRig {
  StrandModel strand;

  explicit Bite(double gap, const SimParams& p = wallParams())   // [m]
      : StepRig(p, needlePose(buildStrand(p), gap, 0.0)), strand(model.strand) {}
  void push(double gap, double angle) { needleTo(needlePose(strand, gap, angle)); step(); }   // [m], [rad]
  double tipForce() const { return state.tools[kRight].force.norm(); }          // [N]
  Vec3 tip() const { return strandPoint(model.strand, state.strand, tipCoordinate(model.strand)); }
  double wallDent() const {                    // [m] of the face at the entry: how far its nearest vertex has gone in
    double most = 0.0;                         // [m]
    for (std::size_t i = 0; i < state.tissue.position.size(); ++i)
      if (model.mesh.vertices[i].x() > kWallX - 1e-9) most = std::max(most, kWallX - state.tissue.position[i].x());
    return most;
  }
};

struct Puncture {
  bool happened = false, flagged = false, flaggedEarlier = false;
  double forceBefore = 0.0, forceAfter = 0.0;  // [N] on the hand: the step before, and 20 ms later
  double contactForce = 0.0, dent = 0.0;       // [N] of the tip on the surface in the step before; [m]
  std::array<double, 3> share{};               // [1] weights of the entry, those of the corners of the touched triangle
  Hole entry;
};

/// Slope of the push on the tip over the tip's way in, between a fifth and four fifths of the puncture force [N/m].
double punctureStiffness(Bite& b) {
  const double limit = b.model.params.needle.punctureForce;   // [N]
  double force[2] = {}, depth[2] = {};         // [N], [m] at the two ends
  for (int k = 0; k < 6000; ++k) {
    b.push(0.1e-3 - 1e-6 * k, 0.0);            // 1 mm/s
    const double f = b.tipForce();             // [N]
    if (f < 0.2 * limit) { force[0] = f; depth[0] = -b.tip().x(); }
    if (f > 0.8 * limit) { force[1] = f; depth[1] = -b.tip().x(); break; }
  }
  return (force[1] - force[0]) / (depth[1] - depth[0]);
}

/// Presses straight in at 5 mm/s until the wall gives way.
Puncture pressThrough(Bite& b) {
  Puncture p;
  for (int k = 0; k < 3000 && !p.happened; ++k) {
    p.forceBefore = b.tipForce();
    p.dent = b.wallDent();
    for (int c = 0; c < b.state.strand.contactCount; ++c)
      if (b.state.strand.contacts[c].sample + 1 == static_cast<int>(b.state.strand.nearVertex.size()))
        p.contactForce = b.state.strand.contacts[c].normalForce;
    b.push(0.5e-3 - 5e-6 * k, 0.0);
    p.happened = b.happened(EventKind::kNeedleEntered);
    p.flagged = b.out.contact[kRight].puncture;
    p.flaggedEarlier = p.flaggedEarlier || (p.flagged && !p.happened);
  }
  p.entry = b.state.strand.holes[0];
  for (int k = 0; k < 20; ++k) b.step();
  p.forceAfter = b.tipForce();
  return p;
}

TEST(Needle, DimplesTheWallFirstAndPuncturesAtThePunctureForce) {
  Bite b(0.5e-3);
  const Puncture p = pressThrough(b);
  ASSERT_TRUE(p.happened);
  RecordProperty("force_on_hand_before", std::to_string(p.forceBefore));
  RecordProperty("tip_force_before", std::to_string(p.contactForce));
  RecordProperty("dent_mm", std::to_string(1e3 * p.dent));
  EXPECT_GT(p.dent, 0.2e-3);
  EXPECT_NEAR(p.contactForce / b.model.params.needle.punctureForce, 1.0, 0.05);
  EXPECT_NEAR(p.forceBefore / b.model.params.needle.punctureForce, 1.0, 0.10);
}

/// A flat punch of the needle's radius on a half space, k = 2 a E / (1 - nu^2) (physics.md 0.5): at the large-strain moduli of the
/// colon it lies about paper 003's 1100 N/m.
TEST(Needle, AWallAtLargeStrainModuliIsAsStiffToTheTipAsThePunchFormulaSays) {
  for (double modulus : {0.63e6, 1.05e6, 1.76e6}) {            // [Pa] Massalou 2019; their geometric mean
    SimParams p = wallParams();
    p.tissue.youngsModulus = modulus;
    Bite b(0.5e-3, p);
    const double nu = p.tissue.poissonRatio, punch = 2.0 * p.needle.wireRadius * modulus / (1.0 - nu * nu);   // [1], [N/m]
    const double felt = punctureStiffness(b);                  // [N/m]
    RecordProperty("stiffness_at_" + std::to_string(static_cast<int>(modulus * 1e-3)) + "_kpa", std::to_string(felt));
    EXPECT_NEAR(felt / punch, 1.0, 0.15) << modulus << " Pa";
    if (modulus == 1.05e6) { EXPECT_NEAR(felt / 1100.0, 1.0, 0.2); }
  }
}

TEST(Needle, PunctureIsFlaggedInItsStepAndTheHandsForceDrops) {
  Bite b(0.5e-3);
  const Puncture p = pressThrough(b);
  ASSERT_TRUE(p.happened);
  RecordProperty("force_after", std::to_string(p.forceAfter));
  EXPECT_TRUE(p.flagged);
  EXPECT_FALSE(p.flaggedEarlier);
  EXPECT_LT(p.forceAfter, 0.8 * p.forceBefore);
}

TEST(Needle, EntersAtAPointOfTheTouchedTriangleNotAtAVertex) {
  Bite b(0.5e-3);
  const Puncture p = pressThrough(b);
  ASSERT_TRUE(p.happened);
  double sum = 0.0, most = 0.0, least = 1.0;   // [1]
  for (double w : p.entry.weight) { sum += w; most = std::max(most, w); least = std::min(least, w); }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(least, 0.0);                       // on a face of its tet
  EXPECT_LT(most, 0.95);
  const Vec3 rest = holePoint(b.model, p.entry, b.model.mesh.vertices);
  RecordProperty("off_target_mm", std::to_string(1e3 * (rest - Vec3(kWallX, kEntryY, kEntryZ)).norm()));
  EXPECT_NEAR(rest.x(), kWallX, 1e-12);        // on the wall's face
  EXPECT_LT((rest - Vec3(kWallX, kEntryY, kEntryZ)).norm(), 0.5e-3);
}

/// The dimple turns the surface a little; the face of the wall at rest looks along +x.
TEST(Needle, TheEntryKeepsTheAngleOfTheTip) {
  Bite b(0.5e-3);
  const Puncture p = pressThrough(b);
  ASSERT_TRUE(p.happened);
  const Vec3 tip = strandTangent(b.model.strand, b.state.strand, tipCoordinate(b.model.strand));
  EXPECT_LT(tip.x(), -0.5);
  EXPECT_NEAR(p.entry.entryCosine, -tip.x(), 0.2);
}

TEST(Needle, BackingOutRemovesItsHolesAndTheWallReturnsToRest) {
  Bite b(0.5e-3);
  ASSERT_TRUE(pressThrough(b).happened);
  const double reached = b.tip().x() - kWallX;   // [m]
  bool torn = false;
  for (int k = 0; k < 3000; ++k) {
    b.push(reached + 5e-6 * k, 0.0);
    torn = torn || b.happened(EventKind::kChannelTorn);
  }
  EXPECT_FALSE(torn);
  EXPECT_EQ(b.state.strand.holeCount, 0);
  b.run(1500);
  EXPECT_LT(b.displacement(), 1e-6);
  EXPECT_LT(b.tipForce(), 1e-3);
}

/// Turns the needle about its centre after the puncture until it has come out on the far face.
TEST(Needle, TurnedAboutItsCentreComesOutOnTheFarFace) {
  Bite b(0.5e-3);
  ASSERT_TRUE(pressThrough(b).happened);
  const Vec3 tip = b.tip();
  const double gap = tip.x() - kWallX;           // [m]
  bool exited = false;
  for (int k = 0; k < 1500; ++k) {
    b.push(gap, 1e-3 * k);
    exited = exited || b.happened(EventKind::kNeedleExited);
    ASSERT_TRUE(b.finite());
  }
  ASSERT_TRUE(exited);
  ASSERT_EQ(b.state.strand.holeCount, 2);
  const Hole &entry = b.state.strand.holes[0], &exit = b.state.strand.holes[1];
  const Vec3 in = holePoint(b.model, entry, b.model.mesh.vertices), out = holePoint(b.model, exit, b.model.mesh.vertices);
  EXPECT_NEAR(in.x(), kWallX, 1e-9);
  EXPECT_NEAR(out.x(), 0.0, 1e-9);
  EXPECT_LT(entry.coordinate, exit.coordinate);
  const double r = b.strand.needle.radius;       // [m]
  const double rise = r - std::sqrt(r * r - kWallX * kWallX);                  // [m] of the arc across the wall
  RecordProperty("rise_over_arc", std::to_string((out.z() - in.z()) / rise));
  EXPECT_NEAR(out.z() - in.z(), rise, 0.6e-3);
  EXPECT_LT(std::fabs(out.y() - in.y()), 0.3e-3);
}

/// Half way round and out on the far face, then all the way back: nothing tears, no hole stays.
TEST(Needle, TurnedBackAfterItsExitLeavesNoHole) {
  Bite b(0.5e-3);
  ASSERT_TRUE(pressThrough(b).happened);
  const double gap = b.tip().x() - kWallX;       // [m]
  bool exited = false, torn = false;
  const auto turn = [&](double angle) {          // [rad]
    b.push(gap, angle);
    exited = exited || b.happened(EventKind::kNeedleExited);
    torn = torn || b.happened(EventKind::kChannelTorn);
  };
  int k = 0;
  for (; k < 1500 && !exited; ++k) turn(1e-3 * k);
  ASSERT_TRUE(exited);
  for (int past = 0; past < 50; ++past) turn(1e-3 * ++k);
  for (; k > -300; --k) turn(1e-3 * k);
  EXPECT_FALSE(torn);
  EXPECT_EQ(b.state.strand.holeCount, 0);
}

}  // namespace
}  // namespace halsted
