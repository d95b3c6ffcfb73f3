/// Random hands, one with a needle, one with a pen under current, over a wall all of which can be cut.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/cut_rig.h"
#include "tests/sim/hand_noise.h"

namespace halsted {
namespace {

TetMesh wallToCut() {
  TetMesh mesh = wallMesh();
  mesh.cuttable.assign(mesh.tets.size(), 1);
  return mesh;
}

SimParams abuseParams() {
  SimParams p = wallParams();
  p.gravity = Vec3(0, 0, -9.81);
  p.tools[kLeft].kind = ToolKind::kElectrocautery;
  p.needle.punctureForce = 0.3;
  p.cautery.cuttingEnergy = 0.5e7;
  return p;
}

bool finite(const State& s) {
  for (const Vec3& x : s.tissue.position)
    if (!x.allFinite()) return false;
  for (const Vec3& x : s.strand.position)
    if (!x.allFinite()) return false;
  return s.tools[kLeft].force.allFinite() && s.tools[kRight].force.allFinite();
}

/// Nothing that acts may act on what is gone.
bool hangsInNothing(const Model& m, const State& s) {
  const auto bare = [&](int triangle) { return exposed(m.surface, s.tissue.gone, triangle); };
  for (int i = 0; i < s.strand.holeCount; ++i)
    if (s.tissue.gone[s.strand.holes[i].tet]) return true;
  for (int i = 0; i < s.strand.contactCount; ++i)
    if (s.strand.contacts[i].feature < static_cast<int>(m.surface.triangles.size()) && !bare(s.strand.contacts[i].feature)) return true;
  for (const ToolState& t : s.tools) {
    for (int i = 0; i < t.contactCount; ++i)
      if (!bare(t.contactTriangle[i])) return true;
    for (int g = 0; g < t.grasp.count; ++g)
      if (!bare(t.grasp.triangle[g])) return true;
  }
  for (int i = 0; i < s.tissue.pairCount; ++i)
    if (!bare(s.tissue.pairTriangle[i]) || !s.cut->bare[s.tissue.pairVertex[i]]) return true;
  return false;
}

class CutAbuse : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seed, CutAbuse, testing::Values(1, 3, 7, 11));

/// The bounds are those of hands that cut nothing (RandomHands).
TEST_P(CutAbuse, StaysFiniteAndNothingHangsInNothing) {
  CutRig rig(abuseParams(), wallToCut(), kNeedleBeside);
  HandNoise noise(GetParam());
  double most = 0.0, liveliest = 0.0;          // [N], [J]
  for (int k = 0; k < 5000; ++k) {
    noise.move(rig.input);
    rig.input.tools[kLeft].jaw = 0.0;
    rig.step();
    ASSERT_TRUE(finite(rig.state)) << "step " << k;
    ASSERT_FALSE(hangsInNothing(rig.model, rig.state)) << "step " << k;
    for (const ToolState& t : rig.state.tools) most = std::max(most, t.force.norm());
    liveliest = std::max(liveliest, rig.kinetic());
  }
  const CutMetrics& cut = rig.cut();
  std::printf("seed %d: %d of %d tets burnt, %d free, %d taken, %d crumbs, %d tears, %d bites begun; at most %.1f N, %.3f mJ\n",
              static_cast<int>(GetParam()), cut.burnt, static_cast<int>(rig.state.tissue.gone.size()), cut.freePieces, cut.taken, cut.crumbs,
              rig.state.metrics.tears, rig.state.strand.bitesBegun, most, 1e3 * liveliest);
  EXPECT_GT(cut.burnt, 20);
  EXPECT_LT(most, 60.0);
  EXPECT_LT(liveliest, 2e-3);
}

}  // namespace
}  // namespace halsted
