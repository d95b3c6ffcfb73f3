/// A blunt instrument pressed on the wall until it goes through, and drawn out again.
#include <gtest/gtest.h>

#include "sim/tools/perforation.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

/// Closed jaws, shaft along +x, at the face x = 4 mm of the wall between mesh lines.
Pose shaftAgainst(double gap) { return frame(Vec3(kWallX + 1.2e-3 + gap, 12e-3, 5e-3), Vec3::UnitY(), Vec3::UnitZ()); }   // [m] from the jaws' surface to the face

struct Prodded : StepRig {
  int perforated = 0;                          // events
  double with = 0.0, hardest = 0.0;            // [N] of the last of them; on the tool in any step

  explicit Prodded(double strength) : StepRig(params(strength), kNeedleAway, shaftAgainst(20e-3)) {   // [N]
    input.tools[kLeft].jaw = 0.0;
    run(2);                                    // closed where there is nothing to be held
    moveTo(1e-3);
  }
  static SimParams params(double strength) {
    SimParams p = wallParams();
    p.tissue.perforationForce = strength;
    p.tools[kLeft].handForce = 40.0;
    return p;
  }
  /// Moves the hand straight on at 50 mm/s.
  void moveTo(double gap) {                    // [m]
    Vec3& hand = input.tools[kLeft].pose.position;
    const double goal = shaftAgainst(gap).position.x();
    while (hand.x() != goal) {
      const double way = goal - hand.x(), most = 5e-5;           // [m] a step
      hand.x() = way > most ? hand.x() + most : way < -most ? hand.x() - most : goal;
      look();
    }
  }
  void look() {
    step();
    hardest = std::fmax(hardest, tool().force.norm());
    for (int e = 0; e < out.eventCount; ++e) {
      if (out.events[e].kind != EventKind::kWallPerforated) continue;
      ++perforated;
      with = out.events[e].value;
    }
  }
  const ToolState& tool() const { return state.tools[kLeft]; }
};

TEST(Perforation, ComesAtTheForceThatTheWallBearsAndNotBefore) {
  for (const double strength : {2.0, 4.0}) {   // [N]
    Prodded p(strength);
    p.moveTo(-20e-3);
    EXPECT_EQ(p.perforated, 1) << strength;
    EXPECT_EQ(p.state.metrics.perforations, 1);
    EXPECT_GT(p.with, strength);
    EXPECT_LT(p.with, 1.1 * strength);
    EXPECT_LT(p.hardest, 1.3 * strength) << "what lies beside the place pushes, too";
  }
}

TEST(Perforation, OfAWallThatBearsTheHandThereIsNone) {
  Prodded p(60.0);
  p.moveTo(-3e-3);
  p.run(500);
  EXPECT_EQ(p.perforated, 0);
  EXPECT_GT(p.tool().force.norm(), 2.0);
}

TEST(Perforation, TheInstrumentMeetsNothingUntilItIsOutAgain) {
  Prodded p(3.0);
  p.moveTo(-20e-3);
  ASSERT_EQ(p.perforated, 1);
  for (int k = 0; k < 1000; ++k) p.look();
  EXPECT_TRUE(p.tool().through);               // the shaft lies in the wall
  EXPECT_EQ(p.tool().force, Vec3::Zero());
  EXPECT_LT(p.displacement(), 1e-4);           // the wall has sprung back
  EXPECT_LT(p.tissueSpeed(), 1e-3);
  EXPECT_FALSE(p.out.contact[kLeft].ahead);
  p.moveTo(5e-3);
  EXPECT_FALSE(p.tool().through);
  p.moveTo(-0.5e-3);
  EXPECT_GT(p.tool().force.norm(), 0.2) << "and now it touches";
  EXPECT_EQ(p.perforated, 1);
}

/// The face of the wall nearest to this place.
int faceAt(const StepRig& rig, const Vec3& place) {              // [m]
  int nearest = -1;
  double least = 1e300;                        // [m^2]
  for (int f = 0; f < static_cast<int>(rig.model.surface.triangles.size()); ++f) {
    const double far = (pointOn(rig.model.surface, rig.state.tissue.position, f, {1.0 / 3, 1.0 / 3, 1.0 / 3}) - place).squaredNorm();
    if (far < least) { least = far; nearest = f; }
  }
  return nearest;
}

/// Contacts of 14 N each on one place, on both sides of the wall or on one: only what pushes the same way goes through.
TEST(Perforation, WhatJawsSqueezeIsNotPushedThrough) {
  for (const bool squeezed : {true, false}) {
    StepRig rig(wallParams(), kNeedleAway);
    ToolState& t = rig.state.tools[kLeft];
    for (int side = 0; side < 2; ++side) {
      const bool far = side == 1 && squeezed;
      t.contactTriangle[side] = faceAt(rig, {far ? 0.0 : kWallX, 12e-3, 11e-3});
      t.contactWeight[side] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
      t.contactNormal[side] = far ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
      t.contactForce[side] = 14.0 * t.contactNormal[side];
    }
    t.contactCount = 2;
    settlePerforation(rig.model, kLeft, rig.state, rig.out);
    EXPECT_EQ(rig.state.metrics.perforations, squeezed ? 0 : 1);
  }
}

/// Jaws right through the wall, at rest; they have come in by the near face, or are known to both.
struct Skewering : StepRig {
  explicit Skewering(bool both) : StepRig(wallParams(), kNeedleAway, shaftAgainst(-12e-3)) {
    ToolState& t = state.tools[kLeft];
    input.tools[kLeft].jaw = t.jaw = 0.0;
    t.closed = true;
    for (int side = 0; side < (both ? 2 : 1); ++side) {
      t.contactTriangle[side] = faceAt(*this, {side == 0 ? kWallX : 0.0, 12e-3, 5e-3});   // where the jaws' axis meets it
      t.contactWeight[side] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
      t.contactNormal[side] = side == 0 ? Vec3(-Vec3::UnitX()) : Vec3(Vec3::UnitX());
      t.contactForce[side] = 1e-3 * t.contactNormal[side];
      ++t.contactCount;
    }
  }
};

/// Each of its contacts would push a face of the wall into the wall, harder with every step, and neither the tool out of it.
TEST(Perforation, AToolThatIsInByOneFaceAndOutByAnotherIsThrough) {
  Skewering both(true), one(false);
  both.run(3);
  EXPECT_EQ(both.state.metrics.perforations, 1);
  EXPECT_TRUE(both.state.tools[kLeft].through);
  EXPECT_EQ(both.state.tools[kLeft].force, Vec3::Zero());
  EXPECT_LT(both.displacement(), 1e-4);
  one.run(3);
  EXPECT_EQ(one.state.metrics.perforations, 0);
  EXPECT_GT(one.state.tools[kLeft].force.x(), 0.0) << "the wall pushes it back";
}

/// What the wall was pushed with comes free, and no more: the coupling must not throw the tool through.
TEST(Perforation, TheToolFollowsItsHandNoFasterThanAHandMoves) {
  Prodded p(8.0);
  Vec3 last = p.tool().proxy.position;
  const double goal = shaftAgainst(-20e-3).position.x();
  while (p.perforated == 0 || p.tool().lag.norm() > 0.0) {
    Vec3& hand = p.input.tools[kLeft].pose.position;
    if (hand.x() > goal) hand.x() -= 5e-5;
    else FAIL() << "no perforation on the whole way";
    p.look();
    EXPECT_LE((p.tool().proxy.position - last).norm(), 0.6e-3);   // [m] a step: 0.5 m/s and the hand's own way
    last = p.tool().proxy.position;
  }
}

}  // namespace
}  // namespace halsted
