/// The needled body as a kind of model: one step, one state, one procedure table, one picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "sim/needling/needling_angle.h"
#include "sim/needling/needling_scene.h"
#include "tests/sim/needling/body_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted {
namespace {

using halsted::testing::BodyRig;
using halsted::testing::ballBody;
using halsted::testing::kBall;
using halsted::testing::needlingParams;

/// In, twirled, lifted and thrust, out.
void needleOnce(BodyRig& rig) {
  rig.go(20e-3, 20e-3);
  for (int k = 0; k < 4; ++k) rig.twirl(2.6, 400);
  for (int k = 0; k < 3; ++k) { rig.go(15e-3, 20e-3); rig.go(20e-3, 20e-3); }
  rig.go(-5e-3, 20e-3);
}

TEST(NeedledBody, GivesTheHandTheForceOfTheTissue) {
  BodyRig rig;
  rig.go(0.4e-3, 2e-3);
  EXPECT_GT(rig.state.tools[kRight].force.y(), 0.1);
  EXPECT_EQ(rig.state.tools[kRight].force, rig.out.contact[kRight].force);
  EXPECT_EQ(rig.out.contact[kRight].step, rig.state.step);
  EXPECT_EQ(rig.state.tools[kLeft].force, Vec3(Vec3::Zero()));
  rig.to(kLeft, Vec3(-0.03, -4e-3, 0));        // 2 mm into a ball of 200 mm there
  EXPECT_NEAR(rig.state.tools[kLeft].force.norm(), 400 * 1.75e-3, 0.05);
}

/// 60 mm into soft tissue a finger would feel 24 N.
TEST(NeedledBody, PushesAHandNoHarderThanThatCanPush) {
  BodyRig rig;
  rig.to(kLeft, Vec3(0, -60e-3, 0));
  const LocalContact& c = rig.out.contact[kLeft];
  const double strength = rig.model.params.tools[kLeft].handForce;   // [N]
  EXPECT_NEAR(c.force.norm(), strength, 1e-9);
  EXPECT_LT((c.stiffness * c.force).norm(), 1e-6 * strength) << "it gives way";
  rig.to(kLeft, Vec3(0, -20e-3, 0));
  EXPECT_LT(rig.out.contact[kLeft].force.norm(), strength);
  EXPECT_GT(rig.out.contact[kLeft].stiffness.norm(), 1.0);
}

TEST(NeedledBody, ReportsEachLayerOnceAndTheWayOut) {
  BodyRig rig;
  needleOnce(rig);
  EXPECT_EQ(rig.count(EventKind::kNeedleEntered), 1);
  EXPECT_EQ(rig.count(EventKind::kLayerPunctured), 2);
  EXPECT_EQ(rig.count(EventKind::kNeedleExited), 1);
  for (const Event& e : rig.events) {
    if (e.kind == EventKind::kNeedleEntered) { EXPECT_NEAR(e.value, 0.30, 0.02); }
    if (e.kind == EventKind::kLayerPunctured) { EXPECT_NEAR(e.value, e.index == 1 ? 0.04 : 0.15, 0.02); }
  }
}

TEST(NeedledBody, MeasuresWhatTheProcedureAsks) {
  BodyRig rig;
  EXPECT_NEAR(rig.seen(Quantity::kTipToPoint), 0.0, 1e-12);   // nothing measured before the first step
  rig.step();
  EXPECT_NEAR(rig.seen(Quantity::kTipToPoint), 5e-3, 1e-9);
  EXPECT_NEAR(rig.seen(Quantity::kAngleError), 0.0, 1e-3);
  rig.go(18e-3, 20e-3);
  EXPECT_NEAR(rig.seen(Quantity::kNeedleDepth), 18e-3, 1e-9);
  EXPECT_NEAR(rig.seen(Quantity::kDepthError), -2e-3, 1e-9);
  EXPECT_EQ(rig.seen(Quantity::kLayersPunctured), 3.0);
  EXPECT_EQ(rig.seen(Quantity::kNeedleOut), 0.0);
  for (int k = 0; k < 4; ++k) rig.twirl(2.6, 400);
  EXPECT_EQ(rig.seen(Quantity::kTwirls), 3.0); // the last one has not turned back yet
  EXPECT_GT(rig.seen(Quantity::kNeedleGrasp), 1.05);
  rig.to(kRight, rig.input.tools[kRight].pose.position + Vec3(0, 30e-6, 0));
  EXPECT_NEAR(rig.seen(Quantity::kWithdrawalSpeed), 0.03, 1e-6);
  rig.go(-1e-3, 20e-3);
  EXPECT_EQ(rig.seen(Quantity::kNeedleOut), 1.0);
  EXPECT_EQ(rig.seen(Quantity::kNeedleDepth), 0.0);
}

TEST(NeedledBody, MetricsAreThoseOfTheHandsOwnMotion) {
  BodyRig rig;
  needleOnce(rig);
  std::map<std::string, double> m;             // by the name's unit
  for (const auto& [name, value] : summarise(rig.state.metrics, 1.0)) m[name] = value;
  EXPECT_NEAR(m["insertion_angle_deg"], 90.0, 0.1);
  EXPECT_NEAR(m["deepest_m"], 20e-3, 1e-9);
  EXPECT_NEAR(m["depth_error_m"], 0.0, 1e-9);
  EXPECT_NEAR(m["entry_offset_m"], 0.0, 1e-6);
  EXPECT_NEAR(m["lift_amplitude_mean_m"], 5e-3, 1e-9);   // the way in is too long for a stroke
  EXPECT_NEAR(m["twirl_amplitude_mean_deg"], 149.0, 1.0);
  EXPECT_LT(m["twirl_amplitude_cv_1"], 1e-3);
  EXPECT_NEAR(m["peak_withdrawal_speed_m_s"], 0.02, 1e-9);
  EXPECT_GT(m["peak_pull_n"], 0.1);
  EXPECT_EQ(m.count("bites"), 0u);             // a suture's
}

TEST(NeedledBody, SavedAndRestoredItGoesOnToTheSameBits) {
  BodyRig a(needlingParams(), 15);
  a.go(10e-3, 20e-3);
  BodyRig b(needlingParams(), 15);
  std::string error;
  ASSERT_TRUE(load(save(a.state), b.state, error)) << error;
  b.input = a.input;
  EXPECT_EQ(diff(a.state, b.state), "");
  for (BodyRig* rig : {&a, &b}) { rig->twirl(2.0, 100); rig->go(-2e-3, 20e-3); }
  EXPECT_EQ(hash(a.state), hash(b.state));
  b.state.needling->layers[1].now[3].z() += 1e-9;
  EXPECT_THAT(diff(a.state, b.state), ::testing::StartsWith("needling.layers[1].now[3].z: "));
}

TEST(NeedledBody, StepTouchesNoHeap) {
  BodyRig rig(needlingParams(), 15);
  rig.events.reserve(100);
  rig.step();
  const test::RealtimeGuard guard;
  needleOnce(rig);
  EXPECT_EQ(guard.calls(), 0u) << guard.first();
}

TEST(NeedledBody, ASampleThatIsNotANumberMovesNothing) {
  BodyRig rig;
  rig.go(5e-3, 5e-3);
  const double depth = rig.state.needling->depth;   // [m]
  rig.to(kRight, Vec3(std::nan(""), 0, 0));
  EXPECT_EQ(rig.state.needling->depth, depth);
  EXPECT_TRUE(rig.state.tools[kRight].device.position.allFinite());
}

TEST(NeedledBody, RefusesWhatMakesNoSense) {
  SimParams twoNeedles = needlingParams();
  twoNeedles.tools[kLeft].kind = ToolKind::kAcupunctureNeedle;
  EXPECT_THROW(buildModel(twoNeedles, Anatomy{{}, ballBody()}, {}), std::invalid_argument);
  EXPECT_THROW(buildModel(needlingParams(), Anatomy{}, {}), std::invalid_argument);
  Body noPoint = ballBody(), thin = ballBody();
  noPoint.points.clear();
  thin.thickness[1] = -1e-3;
  EXPECT_THROW(buildModel(needlingParams(), Anatomy{{}, noPoint}, {}), std::invalid_argument);
  EXPECT_THROW(buildModel(needlingParams(), Anatomy{{}, thin}, {}), std::invalid_argument);
}

struct Picture {
  BodyRig rig;
  RenderScene scene;
  RenderSnapshot now;

  Picture() {
    describeBody(rig.model, scene);
    prepareSnapshot(rig.model, now);
    look();
  }
  void look() { fillSnapshot(rig.model, rig.state, now); }
  /// Deepest vertex of the skin below the ball.  [m]
  double deepest() const {
    double most = 0.0;                         // [m]
    for (int i = 0; i < rig.model.body->picture.perSurface; ++i) most = std::max(most, kBall - (now.tissue[i] - Vec3(0, -kBall, 0)).norm());
    return most;
  }
};

/// Times that each edge is run along, by direction, of the triangles that are seen.
std::map<std::array<int, 2>, int> edges(const RenderScene& scene, Shown with) {
  std::map<std::array<int, 2>, int> sides;
  for (std::size_t t = 0; t < scene.surface.size(); ++t) {
    const auto shown = static_cast<Shown>(scene.body.shown[t]);
    if (shown != Shown::kAlways && shown != with) continue;
    for (int k = 0; k < 3; ++k) ++sides[{scene.surface[t][k], scene.surface[t][(k + 1) % 3]}];
  }
  return sides;
}

TEST(BodyPicture, TheWholeSkinIsClosedAndLiesOnTheBall) {
  const Picture picture;
  const auto sides = edges(picture.scene, Shown::kWhole);
  for (const auto& [side, count] : sides) ASSERT_TRUE(count == 1 && sides.count({side[1], side[0]}) == 1);
  for (int i = 0; i < picture.rig.model.body->picture.perSurface; ++i) EXPECT_NEAR((picture.scene.tissueRest[i] - Vec3(0, -kBall, 0)).norm(), kBall, 1e-12);
  for (std::size_t t = 0; t < picture.scene.surface.size(); ++t) {   // seen from outside, counter-clockwise
    const auto& v = picture.scene.surface[t];
    if (picture.scene.triangleLayer[t] != static_cast<int>(TissueLook::kSkin)) continue;
    const Vec3 &a = picture.scene.tissueRest[v[0]], &b = picture.scene.tissueRest[v[1]], &c = picture.scene.tissueRest[v[2]];
    ASSERT_GT((b - a).cross(c - a).dot(a - Vec3(0, -kBall, 0)), 0.0);
  }
}

TEST(BodyPicture, TheCutawayLeavesNoEdgeOpen) {   // every edge of skin that the cut opens has a wall
  const Picture picture;
  const auto sides = edges(picture.scene, Shown::kCutaway);
  for (const auto& [side, count] : sides) {
    const auto other = sides.find({side[1], side[0]});
    ASSERT_TRUE(count == 1 && other != sides.end() && other->second == 1) << side[0] << " " << side[1];
  }
}

TEST(BodyPicture, SkinDimplesWithTheTipAndSpringsBack) {
  Picture picture;
  EXPECT_LT(picture.deepest(), 1e-9);
  picture.rig.go(0.4e-3, 2e-3);
  picture.look();
  EXPECT_NEAR(picture.deepest(), 0.4e-3, 1e-6);
  EXPECT_NEAR(picture.now.needling.dimple[0], 0.4e-3, 1e-6);
  picture.rig.go(3e-3, 10e-3);
  for (int k = 0; k < 300; ++k) picture.rig.step();
  picture.look();
  EXPECT_LT(picture.deepest(), 0.06e-3);
  EXPECT_EQ(picture.now.needling.punctured, 2);
  EXPECT_NEAR((picture.now.tools[kRight].pose.position - Vec3(0, -3e-3, 0)).norm(), 0.0, 1e-9);
}

TEST(BodyPicture, FinestRingsFollowTheNeedleAndStayOnTheSkin) {
  Picture picture;
  const double top = std::sqrt(kBall * kBall - 1e-6) - kBall;   // [m] 1 mm aside
  picture.rig.to(kRight, Vec3(1e-3, top - 0.4e-3, 0));
  picture.look();
  EXPECT_NEAR(picture.deepest(), 0.4e-3, 5e-6);
  int near = 0;                                // vertices within a tenth of a millimetre of the tip's line
  for (int i = 0; i < picture.rig.model.body->picture.perSurface; ++i) near += std::hypot(picture.now.tissue[i].x() - 1e-3, picture.now.tissue[i].z()) < 0.1e-3;
  EXPECT_GT(near, 100);
}

TEST(BodyPicture, APressingFingerDentsTheSkin) {
  Picture picture;
  picture.rig.to(kLeft, Vec3(0, -2e-3, 0));
  picture.look();
  EXPECT_NEAR(picture.deepest(), 2e-3, 1e-4);
  EXPECT_NEAR(picture.now.needling.pressed, 2e-3, 1e-9);
}

}  // namespace
}  // namespace halsted
