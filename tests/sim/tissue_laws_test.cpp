/// What holds for every tissue solver, whatever its stiffness: free fall, momentum, energy, bad shapes, bits.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/sim/tissue_block.h"

namespace halsted {
namespace {

class TissueLaws : public testing::TestWithParam<TissueSolver> {
 protected:
  static SimParams freeBody() {
    SimParams p = sceneParams(GetParam());
    p.tissue.massDamping = 0.0;
    return p;
  }
  static TetMesh smallBlock() { return blockMesh(5, 4, 3, Vec3(10e-3, 8e-3, 6e-3)); }

  static int substeps(const TissueModel& m) {
    if (m.solver == TissueSolver::kXpbd) return m.xpbd.substeps;
    return m.solver == TissueSolver::kShapeMatching ? m.shape.substeps : 1;
  }
};
INSTANTIATE_TEST_SUITE_P(Tissue, TissueLaws,
                         testing::Values(TissueSolver::kProjective, TissueSolver::kXpbd, TissueSolver::kShapeMatching),
                         [](const auto& solver) { return solverName(solver.param); });

struct Momentum { Vec3 linear = Vec3::Zero(), angular = Vec3::Zero(); double size = 0.0; };   // [kg m/s], [kg m^2/s], [kg m^2/s]

Momentum momentum(const TissueBlock& block) {
  Momentum out;
  for (std::size_t i = 0; i < block.model.mass.size(); ++i) {
    const Vec3 p = block.model.mass[i] * block.state.velocity[i];
    out.linear += p;
    out.angular += block.state.position[i].cross(p);
    out.size += block.state.position[i].norm() * p.norm();
  }
  return out;
}

/// Velocities of a spin, a drift and a wobble.
void setInMotion(TissueBlock& block) {
  for (std::size_t i = 0; i < block.state.velocity.size(); ++i) {
    const Vec3& x = block.state.position[i];
    block.state.velocity[i] = Vec3(0.02, -0.01, 0.03) + Vec3(3, -5, 8).cross(x) + 0.05 * Vec3(std::sin(900.0 * x.y()), 0.0, std::cos(700.0 * x.x()));
  }
}

TEST_P(TissueLaws, FreeFallIsSymplecticEulerExactly) {                 // V1
  SimParams p = freeBody();
  p.gravity = Vec3(0, -9.81, 0);
  TissueBlock block(smallBlock(), p);
  const int steps = 100, s = substeps(block.model);
  block.run(steps);
  const double h = p.dt / s, n = static_cast<double>(steps) * s;       // [s], [1]
  const double fall = -9.81 * h * h * n * (n + 1.0) / 2.0;             // [m]
  for (std::size_t i = 0; i < block.model.rest.size(); ++i) {
    const Vec3 moved = block.state.position[i] - block.model.rest[i];
    EXPECT_NEAR(moved.y(), fall, 1e-8 * std::fabs(fall));
    EXPECT_NEAR(moved.x(), 0.0, 1e-8 * std::fabs(fall));
    EXPECT_NEAR(block.state.velocity[i].y(), -9.81 * p.dt * steps, 1e-7);
  }
}

TEST_P(TissueLaws, RestIsAFixedPoint) {
  TissueBlock block(smallBlock(), freeBody());
  block.run(100);
  for (std::size_t i = 0; i < block.model.rest.size(); ++i) EXPECT_LT((block.state.position[i] - block.model.rest[i]).norm(), 1e-11);
}

TEST_P(TissueLaws, LinearMomentumIsConserved) {
  TissueBlock block(smallBlock(), freeBody());
  setInMotion(block);
  const Momentum before = momentum(block);
  block.run(50);
  EXPECT_LT((momentum(block).linear - before.linear).norm(), 50 * 1e-10 * before.linear.norm());
}

TEST_P(TissueLaws, AngularMomentumIsNeverCreated) {
  TissueBlock block(smallBlock(), freeBody());
  setInMotion(block);
  const Momentum before = momentum(block);
  block.run(50);
  const Momentum after = momentum(block);
  RecordProperty("kept_after_50_steps", std::to_string(after.angular.norm() / before.angular.norm()));
  EXPECT_LE(after.angular.norm(), 1.001 * before.angular.norm());
  EXPECT_LT((after.angular - before.angular).norm(), 0.25 * before.size);
}

TEST_P(TissueLaws, EnergyNeverGrowsWithoutForces) {
  TissueBlock block(smallBlock(), freeBody());
  for (Vec3& x : block.state.position) x = Vec3(1.15 * x.x(), 0.92 * x.y() + 0.1 * x.x(), x.z());
  const double start = block.elastic() + block.kinetic();             // [J]
  double last = start;
  for (int k = 0; k < 400; ++k) {
    block.run(1);
    const double now = block.elastic() + block.kinetic();
    if (GetParam() != TissueSolver::kShapeMatching) { ASSERT_LE(now, last + 1e-4 * start) << "step " << k; }
    ASSERT_LE(now, start * (1.0 + 1e-9));
    last = now;
  }
  EXPECT_LT(last, 0.5 * start);
}

TEST_P(TissueLaws, ComesBackFromFlatAndInvertedTets) {
  SimParams p = freeBody();
  p.tissue.massDamping = 20.0;
  TissueBlock block(smallBlock(), p);
  for (int i : {31, 60, 75}) {                 // inner particles pushed through their neighbours, and a corner onto a face
    block.state.position[i] += Vec3(3e-3, 2.5e-3, -2.2e-3);
  }
  block.state.position[0] = block.state.position[1];
  block.run(600);
  ASSERT_TRUE(block.finite());
  for (int t = 0; t < static_cast<int>(block.model.tets.size()); ++t) EXPECT_GT(block.deformation(t).determinant(), 0.5) << "tet " << t;
}

TEST_P(TissueLaws, StaysFiniteWhenCollapsedToAPlaneALineOrAPoint) {
  for (const Vec3& scale : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(-1, -1, -1), Vec3(50, 50, 50)}) {
    TissueBlock block(smallBlock(), freeBody());
    for (Vec3& x : block.state.position) x = x.cwiseProduct(scale);
    block.run(50);
    EXPECT_TRUE(block.finite()) << scale.transpose();
  }
}

TEST_P(TissueLaws, HeldParticlesStayAndTheRestHangs) {
  SimParams p = sceneParams(GetParam());
  p.gravity = Vec3(0, 0, -9.81);
  TetMesh mesh = smallBlock();
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
    if (mesh.vertices[i].x() == 0.0) mesh.fixed.push_back(i);
  TissueBlock block(mesh, p);
  block.run(300);
  for (int i : block.mesh.fixed) EXPECT_EQ(block.state.position[i], block.model.rest[i]);
  EXPECT_LT(block.meanOnPlane(2, 0.0), 0.0);
  EXPECT_GT(block.meanOnPlane(2, 0.0), -2e-3);
}

TEST_P(TissueLaws, WideLanesGiveTheBitsOfPlainDoubles) {
  SimParams p = sceneParams(GetParam());
  p.gravity = Vec3(1, -9.81, 2);
  TetMesh mesh = blockMesh(5, 3, 2, Vec3(10e-3, 8e-3, 6e-3));          // 180 tets, 72 particles: some groups are not full
  mesh.fixed = {0, 1, 2};
  TissueBlock wide(mesh, p), plain(mesh, p);
  plain.model.projective.wide = false;
  plain.model.xpbd.path = plain.model.shape.path = LanePath::kSerial;
  setInMotion(wide);
  setInMotion(plain);
  wide.run(200);
  plain.run(200);
  const std::size_t bytes = wide.state.position.size() * sizeof(Vec3);
  EXPECT_EQ(std::memcmp(wide.state.position.data(), plain.state.position.data(), bytes), 0);
  EXPECT_EQ(std::memcmp(wide.state.velocity.data(), plain.state.velocity.data(), bytes), 0);
  EXPECT_EQ(std::memcmp(wide.state.rotation.data(), plain.state.rotation.data(), wide.state.rotation.size() * sizeof(Quat)), 0);
}

/// The same from gcc and clang, Debug and Release (DESIGN 7). A change of the solver's arithmetic changes these numbers on purpose;
/// then run the test in every build before writing down new ones.
TEST_P(TissueLaws, EveryBuildGivesTheseBits) {
  if (GetParam() == TissueSolver::kProjective) GTEST_SKIP() << "the scenes' golden hashes cover the default solver";
  SimParams p = sceneParams(GetParam());
  p.gravity = Vec3(1, -9.81, 2);
  TissueBlock block(blockMesh(7, 5, 3, Vec3(14e-3, 10e-3, 6e-3)), p);
  for (std::size_t i = 0; i < block.state.velocity.size(); ++i) block.state.velocity[i] = Vec3(3, -5, 8).cross(block.state.position[i]);
  for (Vec3& x : block.state.position) x.x() *= 1.3;
  block.run(200);
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const Vec3& x : block.state.position)
    for (int a = 0; a < 3; ++a) {
      sum = (sum ^ std::bit_cast<std::uint64_t>(x[a])) * 0x100000001b3ULL;
      sum ^= sum >> 32;
    }
  EXPECT_EQ(sum, GetParam() == TissueSolver::kXpbd ? 0x7a3502b8f1156c14ULL : 0x4a5c21b03ed1ac89ULL);
}

TEST_P(TissueLaws, ASecondRunGivesTheSameBits) {
  TissueBlock first(smallBlock(), freeBody());
  setInMotion(first);
  first.run(60);
  std::vector<double> disturbHeap(12345, 1.0);
  TissueBlock second(smallBlock(), freeBody());
  for (double& x : second.work.scratch) x = 7.0;                       // scratch contents mean nothing
  for (double& x : second.work.rows) x = -3.0;
  setInMotion(second);
  second.run(60);
  EXPECT_EQ(std::memcmp(first.state.position.data(), second.state.position.data(), first.state.position.size() * sizeof(Vec3)), 0);
}

/// The solve passes over what a push at one point leaves alone, whole pieces of the tissue among them, and takes columns of the way back
/// in its own order. With the other right-hand sides full it passes over nothing: the bits are the same, and the answer solves the equation.
void expectSkippingChangesNoBit(const TetMesh& mesh) {
  const TissueBlock b(mesh, sceneParams(TissueSolver::kProjective));
  const ProjectiveModel& p = b.model.projective;
  for (int at : {0, 17, p.size / 2, p.size - 1}) {
    std::vector<double> alone(4 * p.size, 0.0), full(4 * p.size);      // [N], then [m]
    for (std::size_t i = 0; i < full.size(); ++i) full[i] = i % 4 == 0 ? 0.0 : 1.0 + 0.01 * static_cast<double>(i % 13);
    alone[4 * p.permutation[at]] = full[4 * p.permutation[at]] = 1.0;
    solveFactor(p, alone.data());
    solveFactor(p, full.data());
    for (int i = 0; i < p.size; ++i) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(alone[4 * i]), std::bit_cast<std::uint64_t>(full[4 * i])) << at << ' ' << i;
      ASSERT_EQ(alone[4 * i + 1], 0.0);
    }
    if (b.model.isFixed[at]) continue;         // nothing moves it
    for (int i = 0; i < p.size; ++i) EXPECT_NEAR(alone[4 * p.permutation[i]], compliance(p, i, at), 1e-12 * p.self[at]) << at << ' ' << i;
  }
}

/// Two pieces of different size, each held at its foot: four parts and more to the factor.
TetMesh twoPieces() {
  TetMesh both = blockMesh(5, 4, 2, Vec3(15e-3, 12e-3, 4e-3));
  const TetMesh other = blockMesh(4, 3, 2, Vec3(12e-3, 9e-3, 4e-3));
  const int first = static_cast<int>(both.vertices.size());
  for (const Vec3& v : other.vertices) both.vertices.push_back(v + Vec3(0.1, 0.0, 0.0));
  for (auto tet : other.tets) {
    for (int& v : tet) v += first;
    both.tets.push_back(tet);
  }
  for (std::size_t i = 0; i < both.vertices.size(); ++i)
    if (both.vertices[i].y() < 1e-9) both.fixed.push_back(static_cast<int>(i));
  both.surface = boundaryTriangles(both.tets);
  return both;
}

TEST(FactoredSolve, WhatItPassesOverChangesNoBit) {
  expectSkippingChangesNoBit(blockMesh(9, 7, 2, Vec3(27e-3, 21e-3, 4e-3)));
  expectSkippingChangesNoBit(twoPieces());
}

}  // namespace
}  // namespace halsted
