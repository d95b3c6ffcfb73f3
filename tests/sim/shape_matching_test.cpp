/// V6 of physics.md: what overlapping shape matching promises. It has no modulus, so nothing here speaks of stiffness in pascals.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/sim/tissue_block.h"

namespace halsted {
namespace {

TissueBlock block(int substeps = 1, int iterations = 1) {
  SimParams p = sceneParams(TissueSolver::kShapeMatching);
  p.tissue.massDamping = 0.0;
  p.tissue.substeps = substeps;
  p.tissue.shapeIterations = iterations;
  return TissueBlock(blockMesh(6, 5, 1, Vec3(18e-3, 15e-3, 2e-3)), p);
}

Quat spread(int n) {
  const Vec3 axis(std::sin(1.0 + n), std::cos(2.3 * n), std::sin(0.7 * n + 2.0));
  return Quat(Eigen::AngleAxisd(std::fmod(0.61803398875 * n, 1.0) * 3.14159265358979312, axis.normalized()));
}

void place(TissueBlock& b, const Quat& turn, const Vec3& shift) {      // shift [m]
  for (std::size_t i = 0; i < b.model.rest.size(); ++i) {
    b.state.position[i] = turn * b.model.rest[i] + shift;
    b.state.velocity[i].setZero();
  }
}

double largestMove(const TissueBlock& b, const Quat& turn, const Vec3& shift) {   // [m]
  double worst = 0.0;
  for (std::size_t i = 0; i < b.model.rest.size(); ++i)
    worst = std::max(worst, (b.state.position[i] - (turn * b.model.rest[i] + shift)).norm());
  return worst;
}

TEST(ShapeMatching, ARigidlyMovedBodyStaysForAThousandRotations) {
  TissueBlock b = block(1, 2);
  for (int n = 0; n < 1000; ++n) {
    const Quat turn = spread(n);
    const Vec3 shift(0.01 * n, -0.02 * n, 0.5);
    for (Quat& q : b.state.rotation) q = turn;
    place(b, turn, Vec3(0.01, -0.02, 0.05));
    b.run(1);
    ASSERT_LT(largestMove(b, turn, Vec3(0.01, -0.02, 0.05)), 1e-12) << n;
  }
}

TEST(ShapeMatching, TheRotationIsFoundFromAnyWarmStart) {
  TissueBlock b = block();
  for (int n = 0; n < 200; ++n) {
    const Quat turn = spread(n), wrong = spread(3 * n + 1);
    for (Quat& q : b.state.rotation) q = wrong;
    for (int k = 0; k < 60; ++k) {
      place(b, turn, Vec3::Zero());
      b.run(1);
    }
    ASSERT_LT(largestMove(b, turn, Vec3::Zero()), 1e-12) << n;
  }
}

TEST(ShapeMatching, RotationsStayUnitAndProperUnderReflection) {
  TissueBlock b = block(8, 2);
  for (Vec3& x : b.state.position) x.z() = -x.z();
  b.run(30);
  ASSERT_TRUE(b.finite());
  for (const Quat& q : b.state.rotation) {
    EXPECT_NEAR(q.norm(), 1.0, 1e-14);
    EXPECT_NEAR(q.toRotationMatrix().determinant(), 1.0, 1e-13);
  }
}

/// One projection from standstill: the moves' momentum and torque about the starting points vanish. Velocity-level drift over
/// substeps belongs to position-based time stepping and is bounded in TissueLaws.
TEST(ShapeMatching, AProjectionExertsNoNetForceAndNoTorque) {
  TissueBlock b = block();
  std::vector<Vec3> start;                     // [m]
  for (const Vec3& x : b.model.rest)
    start.push_back(spread(7) * Vec3(1.2 * x.x() + 0.2 * x.y(), 0.9 * x.y(), 1.1 * x.z()) + 1e-3 * Vec3(std::sin(400 * x.y()), std::cos(300 * x.x()), 0));
  for (int k = 0; k < 40; ++k) {               // the rotations settle while the shape is held
    b.state.position = start;
    b.state.velocity.assign(start.size(), Vec3::Zero());
    b.run(1);
  }
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();                    // [kg m], [kg m^2]
  double size = 0.0;                                                   // [kg m]
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 moved = b.model.mass[i] * (b.state.position[i] - start[i]);
    force += moved;
    torque += start[i].cross(moved);
    size += moved.norm();
  }
  ASSERT_GT(size, 1e-12);
  EXPECT_LT(force.norm(), 1e-10 * size);
  EXPECT_LT(torque.norm(), 1e-10 * size * 18e-3);
}

TEST(ShapeMatching, EveryParticleLeadsAClusterOfItsNeighbours) {
  const TissueBlock b = block();
  const ShapeMatchingModel& s = b.model.shape;
  ASSERT_EQ(s.clusterStart.size(), b.model.rest.size() + 1);
  for (std::size_t c = 0; c + 1 < s.clusterStart.size(); ++c) {
    const auto first = s.member.begin() + s.clusterStart[c], last = s.member.begin() + s.clusterStart[c + 1];
    EXPECT_EQ(last - first, ShapeMatchingModel::kMembers);
    EXPECT_TRUE(std::binary_search(first, last, static_cast<int>(c)));
    EXPECT_TRUE(std::is_sorted(first, last));
    for (auto i = first; i != last; ++i) EXPECT_LT((b.model.rest[*i] - b.model.rest[c]).norm(), 15e-3);
  }
}

/// A shared sum is a sum like any other: written out, every list has each of its members once. And sharing saves additions.
TEST(ShapeMatching, ThePlanOfSumsAddsEveryMemberOnce) {
  const TissueBlock b = block();
  const ShapeMatchingModel& s = b.model.shape;
  const int inputs = static_cast<int>(b.model.rest.size()), sums = static_cast<int>(s.gather.shared.size()) / 2;
  std::vector<std::vector<int>> holds;           // per node: its inputs
  for (int i = 0; i < inputs; ++i) holds.push_back({i});
  const auto node = [](int offset) { return offset / ShapeMatchingModel::kMap; };
  for (int k = 0; k < sums; ++k) {
    ASSERT_LT(node(std::max(s.gather.shared[2 * k], s.gather.shared[2 * k + 1])), inputs + k);
    std::vector<int> both = holds[node(s.gather.shared[2 * k])];
    const auto& other = holds[node(s.gather.shared[2 * k + 1])];
    both.insert(both.end(), other.begin(), other.end());
    holds.push_back(both);
  }
  std::size_t listed = 0;
  for (int c = 0; c < inputs; ++c) {
    std::vector<int> found;
    const int group = c / SumPlan::kLists;
    for (int k = s.gather.start[group] + c % SumPlan::kLists; k < s.gather.start[group + 1]; k += SumPlan::kLists) {
      if (node(s.gather.node[k]) == inputs + sums) continue;           // the empty map, which fills up
      const auto& part = holds[node(s.gather.node[k])];
      found.insert(found.end(), part.begin(), part.end());
      ++listed;
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, std::vector<int>(s.member.begin() + s.clusterStart[c], s.member.begin() + s.clusterStart[c + 1])) << c;
  }
  EXPECT_LT(2 * (listed + sums), s.member.size());
}

/// A third of a body under load keeps its shape better with more iterations and substeps: it has no modulus to be true to.
TEST(ShapeMatching, StiffnessDependsOnTheIterationCount) {
  double stretch[2];                           // [m]
  for (int k : {0, 1}) {
    TissueBlock b = block(1, k == 0 ? 1 : 8);
    b.model.massDamping = 60.0;
    b.pull(Vec3(200.0, 0, 0).asDiagonal());
    b.run(1500);
    stretch[k] = b.meanOnPlane(0, 18e-3) - b.meanOnPlane(0, 0.0) - 18e-3;
  }
  EXPECT_GT(stretch[0], 1.5 * stretch[1]);
  EXPECT_GT(stretch[1], 0.0);
}

}  // namespace
}  // namespace halsted
