/// What instruments and thread do to the wall they press on, against sums by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim/damage.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr int kInstrument = static_cast<int>(Presser::kInstrument), kStrand = static_cast<int>(Presser::kStrand);

struct Borne : StepRig {
  int face = -1;                               // on x = 4 mm
  Borne() : StepRig(wallParams(), kNeedleAway) {
    for (std::size_t f = 0; f < model.surface.triangles.size(); ++f) {
      const auto& t = model.surface.triangles[f];
      if (std::all_of(t.begin(), t.end(), [&](int v) { return model.mesh.vertices[v].x() > kWallX - 1e-9; })) face = static_cast<int>(f);
    }
  }
  int corner() const { return model.surface.triangles[face][0]; }
  double cell() const { return model.surface.cell[corner()]; }   // [m^2]

  /// The left tool presses on one corner of the face with a force [N]: borne by that corner's cell alone.
  void press(double force) {
    ToolState& t = state.tools[kLeft];
    t.contactCount = 1;
    t.contactTriangle[0] = face;
    t.contactWeight[0] = {1.0, 0.0, 0.0};
    t.contactNormal[0] = -Vec3::UnitX();
    t.contactForce[0] = -force * Vec3::UnitX();
  }
  void bear(double time) {                     // [s]
    const int steps = static_cast<int>(time / model.params.dt + 0.5);
    for (int k = 0; k < steps; ++k) measureDamage(model, state);
  }
  const DamageMetrics& damage() const { return state.metrics.damage; }
};

TEST(Damage, CellsAreTheWholeSurface) {
  const Borne b;
  const double all = std::accumulate(b.model.surface.cell.begin(), b.model.surface.cell.end(), 0.0);   // [m^2]
  EXPECT_NEAR(all, 2.0 * (kWallX * kWallY + kWallX * kWallZ + kWallY * kWallZ), 1e-12);
}

TEST(Damage, ForceTimeIsForceOverTime) {
  Borne b;
  b.press(2.0);
  b.bear(3.0);
  EXPECT_NEAR(b.damage().forceTime[kLeft], 6.0, 1e-9);
  EXPECT_EQ(b.damage().forceTime[kRight], 0.0);
}

TEST(Damage, WhatBowelBearsLeavesNothing) {
  Borne b;
  b.press(0.99 * kTraumaPressure * b.cell());
  b.bear(12.0);
  EXPECT_NEAR(b.damage().peakPressure[kInstrument], 0.99 * kTraumaPressure, 1.0);
  EXPECT_EQ(b.damage().dose[kInstrument], 0.0);
  EXPECT_EQ(b.damage().injured[kInstrument], 0.0);
}

TEST(Damage, DoseIsWhatGoesBeyondOverAreaAndTimeAndTenSecondsInjure) {
  Borne b;
  b.press(1.5 * kTraumaPressure * b.cell());
  b.bear(6.0);
  EXPECT_NEAR(b.damage().dose[kInstrument], 0.5 * kTraumaPressure * b.cell() * 6.0, 1e-9);
  EXPECT_EQ(b.damage().injured[kInstrument], 0.0);
  b.press(0.0);
  b.bear(5.0);                                 // time without pressure neither heals nor counts
  b.press(1.5 * kTraumaPressure * b.cell());
  b.bear(3.9);
  EXPECT_EQ(b.damage().injured[kInstrument], 0.0);
  b.bear(0.2);
  EXPECT_DOUBLE_EQ(b.damage().injured[kInstrument], b.cell());
  b.bear(20.0);
  EXPECT_DOUBLE_EQ(b.damage().injured[kInstrument], b.cell()) << "a cell is injured once";
  EXPECT_EQ(b.damage().injured[kStrand], 0.0);
}

/// Thread is thin: what a cell bears of an instrument without harm, thread cuts into it.
TEST(Damage, ThreadIsBorneByTheStripUnderIt) {
  Borne b;
  const double force = 0.5 * kTraumaPressure * b.cell();         // [N]
  b.state.strand.contactCount = 1;
  b.state.strand.contacts[0] = {10, b.face, force, force * Vec3::UnitX(), {1.0, 0.0, 0.0}};
  b.bear(1.0);
  const double strip = 2.0 * b.model.strand.radius * std::sqrt(b.cell());   // [m^2]
  EXPECT_NEAR(b.damage().peakPressure[kStrand], force / strip, 1.0);
  EXPECT_NEAR(b.damage().dose[kStrand], force - kTraumaPressure * strip, 1e-9);   // [N s] of one second
  EXPECT_EQ(b.damage().peakPressure[kInstrument], 0.0);
}

/// Held tissue bears the pull on it over the jaws' pads.
TEST(Damage, JawsPullOverTheirPads) {
  Borne b;
  TissueGrasp& grasp = b.state.tools[kRight].grasp;
  grasp.count = 2;
  for (int g = 0; g < 2; ++g) {
    grasp.triangle[g] = b.face;
    grasp.weight[g] = {g == 0 ? 1.0 : 0.0, g == 0 ? 0.0 : 1.0, 0.0};
    grasp.force[g] = Vec3(0.0, 3.0, 0.0);
  }
  b.bear(1.0);
  const double pad = 2.0 * b.model.params.tools[kRight].jawRadius * 7e-3;   // [m^2]
  EXPECT_NEAR(b.damage().peakPressure[kInstrument], 6.0 / pad, 1.0);
  EXPECT_NEAR(b.damage().forceTime[kRight], 6.0, 1e-9);
}

/// The picture is told of what instruments did: 1 where the wall is injured.
TEST(Damage, IsInTheSnapshot) {
  Borne b;
  RenderSnapshot picture;
  prepareSnapshot(b.model, picture);
  b.press(1.5 * kTraumaPressure * b.cell());
  b.bear(4.0);
  fillSnapshot(b.model, b.state, picture);
  ASSERT_EQ(picture.bruised.size(), picture.tissue.size());
  EXPECT_NEAR(picture.bruised[b.corner()], 0.4, 1e-9);
  EXPECT_NEAR(std::accumulate(picture.bruised.begin(), picture.bruised.end(), 0.0), 0.4, 1e-9);
}

/// In the step itself: a tool that rests on the wall with a force adds that force's time, and pressure that its contacts add up to.
TEST(Damage, IsMeasuredInTheStep) {
  StepRig rig(wallParams(), kNeedleAway, frame(Vec3(kWallX + 1.2e-3, 12e-3, 11e-3), Vec3::UnitY(), Vec3::UnitZ()));
  rig.input.tools[kLeft].jaw = 0.0;
  double sum = 0.0;                            // [N s]
  for (int k = 0; k < 600; ++k) {
    if (k < 300) rig.input.tools[kLeft].pose.position.x() -= 1e-5;
    rig.step();
    sum += rig.state.tools[kLeft].force.norm() * rig.model.params.dt;
  }
  ASSERT_GT(rig.state.tools[kLeft].force.norm(), 0.2);
  const DamageMetrics& d = rig.state.metrics.damage;
  EXPECT_NEAR(d.forceTime[kLeft], sum, 1e-9);
  EXPECT_GT(d.peakPressure[kInstrument], 0.0);
  EXPECT_LT(d.peakPressure[kInstrument], 2.0 * rig.state.tools[kLeft].force.norm() / (2e-3 * 2e-3 / 2.0));   // no cell is smaller than a corner's
}

}  // namespace
}  // namespace halsted
