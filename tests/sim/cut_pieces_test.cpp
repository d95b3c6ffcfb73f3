/// What a cut leaves: pieces that rest, fall and part as if the tissue between them had never been; and nothing that hangs in nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/cut_rig.h"

namespace halsted {
namespace {

/// The strip without a row, as a mesh of its own.
TetMesh withoutRow(TetMesh mesh, int row) {
  TetMesh rest = mesh;
  rest.tets.clear();
  rest.cuttable.clear();
  rest.cutLine.clear();
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t)
    if (stripRow(t) != row) rest.tets.push_back(mesh.tets[t]);
  rest.surface = boundaryTriangles(rest.tets);
  rest.triangleLayer.assign(rest.surface.size(), 0);
  return rest;
}

/// Held at both ends and pulled aside by its weight: cut, it comes to rest where two strips do that were made in two pieces.
TEST(CutPieces, RestWhereTwoStripsRest) {
  for (TissueSolver solver : {TissueSolver::kProjective, TissueSolver::kXpbd}) {
    SimParams p = cutParams();
    p.gravity = Vec3(60.0, 0, 0);              // [m/s^2] of a sixth of a millimetre
    p.tissue.massDamping = 40.0;
    p.tissue.solver = solver;
    CutRig one(p, Held::kBothEnds), two(p, withoutRow(stripMesh(Held::kBothEnds), kLineRow));
    one.run(300);
    one.vaporise(kLineRow);
    EXPECT_EQ(one.cut().freePieces, 0);        // both are held
    EXPECT_EQ(one.cut().share[0], 1.0);
    one.run(1500);
    two.run(1800);
    double off = 0.0, moved = 0.0;             // [m]
    for (std::size_t i = 0; i < one.state.tissue.position.size(); ++i) {
      off = std::max(off, (one.state.tissue.position[i] - two.state.tissue.position[i]).norm());
      moved = std::max(moved, (two.state.tissue.position[i] - two.model.mesh.vertices[i]).norm());
    }
    RecordProperty("off_um", std::to_string(1e6 * off));
    std::printf("solver %d: sags %.3f mm, off by %.3f um\n", static_cast<int>(solver), 1e3 * moved, 1e6 * off);
    EXPECT_GT(moved, 0.1e-3);
    EXPECT_LT(off, 0.01 * moved);
  }
}

/// Nothing but the kerf's inertia holds a free piece back: a = m g / (m + C dt), C = 2 k mu dt A / w (sim/tissue/projective_model.h).
TEST(CutPieces, FallWithTheInertiaThatTheHeaderNames) {
  SimParams p = cutParams();
  p.gravity = Vec3(0, 0, -9.81);
  p.tissue.massDamping = 0.0;
  CutRig rig(p);
  rig.run(500);
  const double held = rig.elastic();           // [J]
  rig.vaporise(kLineRow);
  ASSERT_EQ(rig.cut().freePieces, 1);
  rig.run(20);
  const double before = rig.freeVelocity().z();                                            // [m/s]
  rig.run(100);
  const double a = (before - rig.freeVelocity().z()) / 0.1;                                // [m/s^2]
  const double area = kStripX * kStripY * kCell * kCell;                                   // [m^2]
  const double added = 2.0 * rig.model.tissue.material.stiffening * rig.model.tissue.material.mu * p.dt * p.dt * area / kCell;   // [kg]
  double mass = 0.0, weight = 0.0;             // [kg], [N]
  for (std::size_t i = 0; i < rig.model.tissue.mass.size(); ++i) {
    if (rig.model.mesh.vertices[i].z() > kLineRow * kCell + 1e-9) continue;
    mass += rig.model.tissue.mass[i];
    weight += 9.81 * rig.model.tissue.mass[i] * rig.state.tissue.left[i];
  }
  RecordProperty("acceleration", std::to_string(a));
  std::printf("falls with %.3f m/s^2; its own mass %.3f g, of the kerf %.3f g: %.3f m/s^2; elastic energy %.3g of %.3g J\n", a, 1e3 * mass, 1e3 * added,
              weight / (mass + added), rig.elastic(), held);
  EXPECT_NEAR(a, weight / (mass + added), 0.03 * a);
  EXPECT_NEAR(weight, 9.81 * 1060.0 * kLineRow * kRowVolume, 1e-9);
}

TEST(CutPieces, FallFreelyWhereTheSolverKeepsNoMatrix) {
  SimParams p = cutParams();
  p.gravity = Vec3(0, 0, -9.81);
  p.tissue.massDamping = 0.0;
  p.tissue.solver = TissueSolver::kXpbd;
  CutRig rig(p);
  rig.run(300);
  rig.vaporise(kLineRow);
  rig.run(20);
  const double before = rig.freeVelocity().z();                                            // [m/s]
  rig.run(50);
  double mass = 0.0, weight = 0.0;             // [kg] both
  for (std::size_t i = 0; i < rig.model.tissue.mass.size(); ++i) {
    if (rig.model.mesh.vertices[i].z() > kLineRow * kCell + 1e-9) continue;
    mass += rig.model.tissue.mass[i];
    weight += rig.model.tissue.mass[i] * rig.state.tissue.left[i];
  }
  EXPECT_NEAR((before - rig.freeVelocity().z()) / 0.05, 9.81 * weight / mass, 0.2);
}

/// Once it parts it parts: no drag of the kerf slows it down, and none pulls the rest along.
TEST(CutPieces, PartWithoutDrag) {
  SimParams p = cutParams();
  p.tissue.massDamping = 0.0;
  CutRig rig(p);
  rig.vaporise(kLineRow);
  rig.throwFree(-0.05);
  rig.run(300);
  EXPECT_NEAR(rig.freeVelocity().z(), -0.05, 0.002);
  EXPECT_NEAR(rig.freePlace().z() - kLineRow * kCell / 2, -0.015, 0.6e-3);
  for (std::size_t i = 0; i < rig.state.tissue.position.size(); ++i) {
    if (rig.state.tissue.piece[i] != 0) continue;
    EXPECT_LT((rig.state.tissue.position[i] - rig.model.mesh.vertices[i]).norm(), 0.3e-3);
  }
}

TEST(CutPieces, NeverGainEnergy) {
  for (int k : {1, 5}) {
    SimParams p = cutParams();
    p.gravity = Vec3(3.0, 0, -9.81);
    p.tissue.massDamping = 0.0;
    p.tissue.stiffening = k;
    p.cautery.takeAway = 1.0;
    CutRig rig(p);
    rig.run(37);                               // swinging
    const double before = rig.kinetic() + rig.elastic();                                   // [J]
    const double high = rig.potential();       // [J]
    rig.vaporise(kLineRow);
    const double lost = high - rig.potential();                                            // [J] with the weight that went up in steam
    double most = 0.0;                         // [J]
    for (int i = 0; i < 400; ++i) {
      rig.step();
      most = std::max(most, rig.kinetic() + rig.elastic() + rig.potential() + lost - high);
    }
    std::printf("stiffening %d: %.4g uJ before, at most %.4g uJ after\n", k, 1e6 * before, 1e6 * most);
    EXPECT_LE(most, before * 1.001);
  }
}

TEST(CutPieces, ThatAreCarriedAwayLeaveTheScene) {
  SimParams p = cutParams();
  p.tissue.massDamping = 0.0;
  CutRig rig(p);
  rig.vaporise(kLineRow);
  rig.throwFree(-0.2);
  int steps = 0;
  while (rig.cut().taken == 0 && steps < 400) { rig.step(); ++steps; }
  EXPECT_NEAR(steps, (30e-3 - kCell) / 0.2 * 1e3, 30);
  EXPECT_EQ(rig.cut().taken, 1);
  EXPECT_EQ(rig.cut().freePieces, 0);
  EXPECT_EQ(rig.count(EventKind::kPieceTaken), 1);
  EXPECT_EQ(rig.out.seen[static_cast<int>(Quantity::kSpecimenTaken)], 1.0);
  RenderSnapshot picture;
  prepareSnapshot(rig.model, picture);
  fillSnapshot(rig.model, rig.state, picture);
  for (int f = 0; f < static_cast<int>(picture.exposed.size()); ++f)
    if (stripRow(rig.model.surface.triangleTet[f]) <= kLineRow) { EXPECT_EQ(picture.exposed[f], 0); }
  rig.run(200);
  for (double z : {rig.freeVelocity().z()}) EXPECT_TRUE(std::isfinite(z));
}

TEST(CutPieces, ACrumbIsSuckedAway) {
  CutRig rig;
  for (int t = 0; t < static_cast<int>(rig.model.mesh.tets.size()); ++t) {   // all of the line's row but one cell's six tets, and that cell's neighbours
    const bool kept = t / 6 == kLineRow * kStripX * kStripY;
    const bool beside = stripRow(t) == kLineRow - 1 || stripRow(t) == kLineRow + 1;
    if ((stripRow(t) == kLineRow && !kept) || beside) rig.state.tissue.gone[t] = 1;
  }
  rig.out.eventCount = 0;
  settlePieces(rig.model, rig.state, rig.out);
  EXPECT_EQ(rig.cut().crumbs, 1);              // 8 mm^3
  EXPECT_EQ(rig.cut().freePieces, 1);          // the specimen
}

/// Thrown back against the stump it is stopped by the new faces, though the kerf's own tets had joined them before.
TEST(CutPieces, MeetAtTheNewFaces) {
  SimParams p = cutParams();
  p.gravity = Vec3(0, 0, 9.81);                // toward what is held
  CutRig rig(p);
  rig.run(100);
  rig.vaporise(kLineRow);
  const auto gap = [&] {                       // [m] between the mean heights of the two faces
    double low = 0.0, high = 0.0;              // [m]
    int n = 0;
    for (std::size_t i = 0; i < rig.state.tissue.position.size(); ++i) {
      const double z = rig.model.mesh.vertices[i].z();
      if (std::fabs(z - kLineRow * kCell) < 1e-9) { low += rig.state.tissue.position[i].z(); ++n; }
      if (std::fabs(z - (kLineRow + 1) * kCell) < 1e-9) high += rig.state.tissue.position[i].z();
    }
    return (high - low) / n;
  };
  double least = 1.0, hardest = 0.0, before = rig.freeVelocity().z();   // [m], [m/s^2] away from what is held, [m/s]
  int strange = 0;                             // pairs of tissue that nothing has laid bare
  for (int k = 0; k < 60; ++k) {
    rig.step();
    least = std::min(least, gap());
    hardest = std::max(hardest, (before - rig.freeVelocity().z()) / rig.model.params.dt);
    before = rig.freeVelocity().z();
    const TissueState& t = rig.state.tissue;
    for (int i = 0; i < t.pairCount; ++i) strange += !rig.state.cut->bare[t.pairVertex[i]] || !exposed(rig.model.surface, t.gone, t.pairTriangle[i]);
  }
  std::printf("least gap %.3f mm, slowed by at most %.1f m/s^2, speed after it %.3f m/s\n", 1e3 * least, hardest, rig.freeVelocity().z());
  EXPECT_GT(least, -0.1e-3);
  EXPECT_LT(least, 0.2e-3);
  EXPECT_GT(hardest, 3.0 * 1.961);             // of its weight, of which the kerf leaves it a fifth (FallWithTheInertiaThatTheHeaderNames)
  EXPECT_LT(rig.freeVelocity().z(), 0.0);      // turned back
  EXPECT_EQ(strange, 0);
}

/// The pen, without current, in the kerf against the new face.
TEST(CutPieces, ToolsMeetTheNewFaces) {
  CutRig rig(cutParams(), Held::kBothEnds);
  rig.vaporise(kLineRow);
  rig.pen(penAt(4e-3, 2.5e-3, (kLineRow + 0.5) * kCell), false);
  rig.run(50);
  EXPECT_LT(rig.state.tools[kLeft].force.norm(), 1e-9);          // between the faces there is nothing
  for (int k = 0; k < 300; ++k) {
    rig.pen(penAt(4e-3, 2.5e-3, (kLineRow + 0.5) * kCell + 1e-3 * k / 300.0), false);
    rig.step();
  }
  const ToolState& t = rig.state.tools[kLeft];
  EXPECT_LT(t.force.z(), -0.02);
  ASSERT_GT(t.contactCount, 0);
  for (int i = 0; i < t.contactCount; ++i) EXPECT_EQ(rig.model.mesh.triangleLayer[t.contactTriangle[i]], kCutFace);
}

TEST(CutPieces, AHoleInATetThatGoesTears) {
  CutRig rig;
  StrandState& s = rig.state.strand;
  const double at[] = {20e-3, 24e-3};          // [m]
  for (int i = 0; i < 2; ++i) {
    const TissuePoint p = tissuePointAt(rig.model, Vec3(3e-3, i ? 3.9e-3 : 0.1e-3, (kLineRow + 0.4) * kCell));
    s.holes[i].tet = p.tet;
    s.holes[i].weight = p.weight;
    s.holes[i].coordinate = at[i];
    s.holes[i].bite = 0;
    s.holes[i].role = static_cast<std::int32_t>(i ? HoleRole::kPassed : HoleRole::kEntry);
  }
  s.holeCount = 2;
  s.bitesBegun = 1;
  rig.state.stitches.emplace();
  const TissuePoint holes[] = {tissuePointAt(rig.model, Vec3(1e-3, 2e-3, 11e-3)), tissuePointAt(rig.model, Vec3(1e-3, 2e-3, 15e-3))};
  ASSERT_TRUE(tieStitch(rig.model, rig.state, holes, 7e-3));
  rig.vaporise(kLineRow);
  EXPECT_EQ(s.holeCount, 0);
  EXPECT_EQ(rig.state.stitches->count, 0);
  EXPECT_EQ(rig.state.metrics.tears, 2);
  EXPECT_EQ(rig.count(EventKind::kChannelTorn), 2);
  rig.run(50);
  EXPECT_LT(rig.state.tissue.velocity[0].norm(), 1e-3);
}

TEST(CutPieces, AGraspOfWhatGoesHoldsNothing) {
  SimParams p = cutParams();
  p.tools[kLeft].kind = ToolKind::kAllis;
  CutRig rig(p);
  rig.input.tools[kLeft].pose = penAt(0.5e-3, 0.3e-3, (kLineRow + 0.5) * kCell);
  rig.run(20);
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(200);
  ASSERT_GT(rig.state.tools[kLeft].grasp.count, 0);
  for (int row : {kLineRow - 1, kLineRow, kLineRow + 1}) rig.vaporise(row);
  EXPECT_EQ(rig.state.tools[kLeft].grasp.count, 0);
  EXPECT_EQ(rig.count(EventKind::kTissueReleased), 1);
  rig.run(50);
  EXPECT_LT(rig.state.tools[kLeft].force.norm(), 1e-9);
}

}  // namespace
}  // namespace halsted
