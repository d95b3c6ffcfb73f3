/// The load of a leak test on a prolapse: it lies turned out, and what has been cut off carries none of it.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/prolapse.h"
#include "sim/cutting/pieces.h"
#include "sim/outcome.h"
#include "sim/portable_math.h"
#include "sim/step.h"
#include "tests/scenes/prolapse_params.h"

namespace halsted {
namespace {

Model prolapseModel() {
  SimParams params;
  params.gravity.setZero();
  params.anvil.radius = 0.0;
  return buildModel(params, scenes::prolapse(prolapsed()), {});
}

State atRest(const Model& m) { return initialState(m, {Pose{Vec3(-0.1, 0.0, 0.1), Quat::Identity()}, Pose{Vec3(0.1, 0.0, 0.1), Quat::Identity()}}); }

/// One row of tets out of each wall, all the way round.
void cutBothWalls(const Model& m, State& s) {
  for (std::size_t t = 0; t < m.mesh.tets.size(); ++t) {
    const CutMark& mark = m.mesh.cutLine[t];
    if (mark.wall >= 0 && std::fabs(mark.fromLine) < 0.1 * scenes::kCutRow) s.tissue.gone[t] = static_cast<std::uint8_t>(Gone::kBurnt);
  }
  findPieces(m, s);
}

std::vector<Vec3> loadOf(const Model& m, const State& s, double pressure) {   // [N] [Pa]
  std::vector<Vec3> load(m.mesh.vertices.size(), Vec3::Zero());
  gatherPressure(m, s, pressure, load);
  return load;
}

/// Away from the axis, on one wall.  [N]
double outwardPush(const Model& m, const std::vector<Vec3>& load, int wall) {
  double sum = 0.0;                            // [N]
  for (std::size_t v = 0; v < load.size(); ++v) {
    if (m.bowels.of[v] != wall) continue;
    const Vec3 out(m.mesh.vertices[v].x(), m.mesh.vertices[v].y(), 0.0);
    sum += load[v].dot(out.normalized());
  }
  return sum;
}

/// Lumen is on the far side of either wall: pressure presses them on each other, each by its own area.
TEST(LumenPressure, PressesTheWallsOfAProlapseOnEachOther) {
  const Model m = prolapseModel();
  const State s = atRest(m);
  const AnatomyParams a = prolapsed();
  const std::vector<Vec3> load = loadOf(m, s, 1000.0);
  const double straight = a.length - scenes::foldHeight(a);      // [m]
  const double outer = 2.0 * kPi * a.radius * straight * 1000.0, inner = 2.0 * kPi * (a.radius - 2.0 * a.wall - a.gap) * straight * 1000.0;   // [N]
  EXPECT_NEAR(outwardPush(m, load, 0) / -outer, 1.0, 0.1) << "the fold adds to it";
  EXPECT_NEAR(outwardPush(m, load, 1) / inner, 1.0, 0.1);
}

TEST(LumenPressure, DoesNotActOnWhatHasBeenCutOff) {
  const Model m = prolapseModel();
  State s = atRest(m);
  cutBothWalls(m, s);
  ASSERT_GE(s.cut->pieces, 1);
  const std::vector<Vec3> load = loadOf(m, s, 1000.0);
  double onRest = 0.0;                         // [N]
  for (std::size_t v = 0; v < load.size(); ++v) {
    if (s.tissue.piece[v] > 0) { EXPECT_EQ(load[v].norm(), 0.0); }
    onRest += load[v].norm();
  }
  EXPECT_GT(onRest, 1.0);
}

/// The edges that are left, and the mucosa opposite to them, whether the cut went along the rim or strayed.
TEST(LumenPressure, MucosaIsOppositeToEveryRowBehindAnEdge) {
  const Model m = prolapseModel();
  for (int wall = 0; wall < kCutWalls; ++wall)
    for (const std::vector<EdgeRow>& rows : m.cut.edge[wall])
      for (const EdgeRow& row : rows) {
        EXPECT_EQ(m.bowels.wallDepth[row.mucosa], 1.0);
        EXPECT_NEAR((m.mesh.vertices[row.mucosa] - m.mesh.vertices[row.vertex]).norm(), prolapsed().wall, 1e-9);
      }
}

}  // namespace
}  // namespace halsted
