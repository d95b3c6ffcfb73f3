/// Laws of the prolapse that needs no data file: two walls, one in the other, joined at the tip, held at the base, to be cut along a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "scenes/procedural_colon.h"
#include "scenes/prolapse.h"
#include "scenes/scene.h"
#include "sim/bowels.h"
#include "sim/portable_math.h"
#include "tests/scenes/prolapse_params.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

double radiusOf(const Vec3& p) { return p.head<2>().norm(); }    // [m]

TEST(Prolapse, HasSomeTwoAndAHalfThousandParticlesWellShaped) {
  const TetMesh mesh = scenes::prolapse(prolapsed());
  EXPECT_GE(mesh.vertices.size(), 2300u);
  EXPECT_LE(mesh.vertices.size(), 2800u);
  EXPECT_EQ(mesh.uv.size(), mesh.vertices.size());
  EXPECT_EQ(mesh.bowel.size(), mesh.vertices.size());
  EXPECT_GT(testing::worstQuality(mesh), 0.2);
}

/// Closed, oriented, outward: each edge once in each direction, and what the surface encloses is what the tets fill.
TEST(Prolapse, HasOneClosedSurfaceThatFacesOutward) {
  const TetMesh mesh = scenes::prolapse(prolapsed());
  std::set<std::array<int, 2>> directed;
  double enclosed = 0.0;                       // [m^3]
  for (const auto& t : mesh.surface) {
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(directed.insert({t[k], t[(k + 1) % 3]}).second);
    enclosed += mesh.vertices[t[0]].cross(mesh.vertices[t[1]]).dot(mesh.vertices[t[2]]) / 6.0;
  }
  for (const auto& [a, b] : directed) EXPECT_TRUE(directed.count({b, a}));
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) EXPECT_GT(volume(mesh, t), 0.0);
  EXPECT_NEAR(enclosed, volume(mesh), 1e-9 * enclosed);
}

/// Two tubes and half of a torus (Pappus); a ring of 36 corners and a fold of four cells leave out three hundredths at most.
TEST(Prolapse, HasTheVolumeOfTwoTubesAndAFold) {
  const AnatomyParams a = prolapsed();
  const double straight = a.length - scenes::foldHeight(a), outer = a.radius - 0.5 * a.wall, inner = outer - a.wall - a.gap;   // [m]
  const double tubes = 2.0 * kPi * (outer + inner) * a.wall * straight;                                                        // [m^3]
  const double fold = 0.5 * kPi * (std::pow(0.5 * a.gap + a.wall, 2) - std::pow(0.5 * a.gap, 2)) * kPi * (outer + inner);      // [m^3]
  EXPECT_NEAR(volume(scenes::prolapse(a)) / (tubes + fold), 1.0, 0.03);
}

TEST(Prolapse, IsAsThickEverywhereAsItsWall) {
  const AnatomyParams a = prolapsed();
  const TetMesh mesh = scenes::prolapse(a);
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 2) EXPECT_NEAR((mesh.vertices[v + 1] - mesh.vertices[v]).norm(), a.wall, 1e-12);
  TetMesh other = mesh;                        // thickness is measured from layer 0: here the mucosa's vertices are the even ones
  for (int& layer : other.triangleLayer) layer = layer == 2 ? 2 : 1 - layer;
  EXPECT_GT(testing::leastDistanceToOuterLayer(other), 0.9 * a.wall) << "a fold of four cells";
  EXPECT_LT(testing::largestDistanceToOuterLayer(other), 1.01 * a.wall);
}

TEST(Prolapse, WallsLieOneInTheOtherAndTheirSerosaeFaceEachOther) {
  const AnatomyParams a = prolapsed();
  const TetMesh mesh = scenes::prolapse(a);
  const Bowels bowels = findBowels(mesh);
  double innerMost = 0.0, outerLeast = 1.0;    // [m] of the straight walls
  const double fold = 0.6 * a.length - scenes::foldHeight(a);    // [m]
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].z() > fold + 1e-9) continue;
    const double r = radiusOf(mesh.vertices[v]);                // [m]
    if (bowels.of[v] == 1) innerMost = std::max(innerMost, r); else outerLeast = std::min(outerLeast, r);
    const bool serosa = bowels.wallDepth[v] == 0.0;
    EXPECT_NEAR(r, bowels.of[v] == 0 ? a.radius - serosa * a.wall : a.radius - a.gap - (2.0 - serosa) * a.wall, 1e-12);
  }
  EXPECT_NEAR(outerLeast - innerMost, a.gap, 1e-12);
}

/// An oval section: both walls follow it, as thick and as far apart in every direction as round ones.
TEST(Prolapse, TakesTheCrossSectionOfARealBowel) {
  const AnatomyParams a = prolapsed();
  std::vector<double> oval;                    // [1]
  for (int c = 0; c < a.around; ++c) oval.push_back(1.0 + 0.15 * cosine(4.0 * kPi * c / a.around));
  const TetMesh round = scenes::prolapse(a), mesh = scenes::prolapse(a, oval);
  ASSERT_EQ(mesh.vertices.size(), round.vertices.size());
  const double middle = a.radius - a.wall - 0.5 * a.gap;         // [m] between the walls
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double further = (oval[(v / 2) % a.around] - 1.0) * middle;   // [m]
    EXPECT_NEAR(radiusOf(mesh.vertices[v]) - radiusOf(round.vertices[v]), further, 1e-12);
    EXPECT_EQ(mesh.vertices[v].z(), round.vertices[v].z());
  }
  EXPECT_GT(testing::worstQuality(mesh), 0.15);
  oval[5] = 0.2;
  testing::expectRefused([&] { scenes::prolapse(a, oval); }, {"too flat", "0.2"});
}

TEST(Prolapse, ReadsTheCrossSectionOffATube) {
  AnatomyParams a = prolapsed();
  a.haustraDepth = 0.0;
  TetMesh tube = scenes::proceduralColon(a);
  for (Vec3& v : tube.vertices) v.x() *= 1.2;
  const std::vector<double> section = scenes::crossSection(tube, a);
  ASSERT_EQ(section.size(), static_cast<std::size_t>(a.around));
  EXPECT_NEAR(section[0] / section[a.around / 4], 1.2, 0.01);
  EXPECT_NEAR(std::accumulate(section.begin(), section.end(), 0.0) / a.around, 1.0, 1e-9);
}

TEST(Prolapse, IsHeldAtTheBaseOfBothWallsAndNowhereElse) {
  const AnatomyParams a = prolapsed();
  const TetMesh mesh = scenes::prolapse(a);
  EXPECT_TRUE(std::is_sorted(mesh.fixed.begin(), mesh.fixed.end()));
  EXPECT_EQ(mesh.fixed.size(), 4u * static_cast<std::size_t>(a.around));
  const std::set<int> held(mesh.fixed.begin(), mesh.fixed.end());
  double top = -1.0;                           // [m]
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    EXPECT_EQ(held.count(v) > 0, mesh.vertices[v].z() < -0.4 * a.length + 1e-9);
    top = std::max(top, mesh.vertices[v].z());
  }
  EXPECT_NEAR(top, 0.6 * a.length, 1e-12);
}

TEST(Prolapse, RimsAreWhatIsSewnAfterTheCut) {
  const AnatomyParams a = prolapsed();
  const Bowels bowels = findBowels(scenes::prolapse(a));
  const TetMesh mesh = scenes::prolapse(a);
  ASSERT_EQ(bowels.count, 2);
  for (const int wall : {0, 1}) {
    ASSERT_EQ(bowels.rim[wall].size(), static_cast<std::size_t>(a.around));
    for (int v : bowels.rim[wall]) {
      EXPECT_NEAR(mesh.vertices[v].z() + 0.4 * a.length, a.cutHeight - 0.5 * scenes::kCutRow, 1e-12);
      EXPECT_EQ(bowels.wallDepth[v], 0.0);
    }
    EXPECT_LT((bowels.opening[wall].axis - Vec3::UnitZ()).norm(), 1e-9) << "both ends face the surgeon";
    EXPECT_LT((bowels.opening[wall].right - Vec3::UnitX()).norm(), 1e-9);
  }
  EXPECT_GT(radiusOf(mesh.vertices[bowels.rim[0][0]]), radiusOf(mesh.vertices[bowels.rim[1][0]]));
}

TEST(Prolapse, IsFinestWhereItMayBeCut) {
  const AnatomyParams a = prolapsed();
  const TetMesh mesh = scenes::prolapse(a);
  ASSERT_EQ(mesh.cutLine.size(), mesh.tets.size());
  std::array<int, 2> count{};
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const CutMark& mark = mesh.cutLine[t];
    ASSERT_EQ(mesh.cuttable[t] != 0, mark.wall >= 0);
    if (mark.wall < 0) continue;
    ++count[mark.wall];
    double low = 1.0, high = -1.0;             // [m]
    for (int v : mesh.tets[t]) {
      low = std::min(low, mesh.vertices[v].z());
      high = std::max(high, mesh.vertices[v].z());
      EXPECT_EQ(mesh.bowel[v], mark.wall);
      const double turn = mesh.uv[v].x() * a.around;            // [1]
      EXPECT_TRUE(turn > mark.bin - 1e-9 || mark.bin == a.around - 1) << "a bin is a column of cells";
    }
    EXPECT_NEAR(high - low, scenes::kCutRow, 1e-12);
    EXPECT_NEAR(0.5 * (high + low) + 0.4 * a.length - a.cutHeight, mark.fromLine, 1e-12) << "positive toward the specimen";
  }
  EXPECT_EQ(count[0], 7 * 6 * a.around);
  EXPECT_EQ(count[1], count[0]);
}

/// What the excision is for: with the row on the line gone from both walls, the fold hangs on nothing; from one wall, it still does.
TEST(Prolapse, ComesFreeWhenBothWallsAreCutAlongTheirLines) {
  const TetMesh mesh = scenes::prolapse(prolapsed());
  const auto freeVertices = [&](bool inner) {
    std::vector<int> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) { while (parent[v] != v) v = parent[v] = parent[parent[v]]; return v; };
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const CutMark& mark = mesh.cutLine[t];
      if (mark.wall >= 0 && std::fabs(mark.fromLine) < 0.1 * scenes::kCutRow && (mark.wall == 0 || inner)) continue;
      for (int c = 1; c < 4; ++c) parent[root(mesh.tets[t][c])] = root(mesh.tets[t][0]);
    }
    std::set<int> held;
    for (int v : mesh.fixed) held.insert(root(v));
    int count = 0;
    for (int v = 0; v < static_cast<int>(parent.size()); ++v) count += held.count(root(v)) == 0;
    return count;
  };
  EXPECT_EQ(freeVertices(false), 0);
  EXPECT_GT(freeVertices(true), static_cast<int>(mesh.vertices.size()) / 3);
}

TEST(Prolapse, GivesTheSameBitsOnEveryMachine) {
  EXPECT_EQ(testing::bitsOf(scenes::prolapse(prolapsed())), testing::bitsOf(scenes::prolapse(prolapsed())));
  EXPECT_EQ(testing::bitsOf(scenes::prolapse(prolapsed())), 15084612311521132824ULL);
}

TEST(Prolapse, IsRefusedWhereItCannotBe) {
  const auto with = [](const std::string& anatomy) {
    return [anatomy] { scenes::parseScene("title = \"t\"\n[anatomy]\nlayout = \"prolapse\"\nradius = 22e-3\nlength = 45e-3\n" + anatomy, "s.toml", ".", {}); };
  };
  EXPECT_NO_THROW(with("gap = 4e-3\nwall = 2.5e-3\n")());
  testing::expectRefused(with("gap = 15e-3\nwall = 2.5e-3\n"), {"s.toml:6: anatomy.gap", "leave no lumen"});
  testing::expectRefused(with("gap = 4e-3\ncut_height = 4e-3\n"), {"anatomy.cut_height", "reaches down to the base"});
  testing::expectRefused(with("gap = 4e-3\ncut_height = 35e-3\n"), {"too short"});
}

}  // namespace
}  // namespace halsted
