/// Tissue against itself: nothing near is overlooked, nothing passes through, and what is held in place flings nothing away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/contact/pair_search.h"
#include "sim/contact/tissue_contact.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

using Pair = std::array<int, 2>;                 // triangle, vertex

/// Two standing plates, 2 mm thick, that face each other across x = 0. When `held` the right one is fixed and the left one at its foot.
TetMesh twoPlates(double gap, bool held) {       // gap [m]
  TetMesh mesh;
  for (double side : {-1.0, 1.0}) {              // [1]
    TetMesh plate = blockMesh(1, 6, 6, Vec3(2e-3, 20e-3, 20e-3));
    const int first = static_cast<int>(mesh.vertices.size());
    const Vec3 place(side > 0.0 ? 0.5 * gap : -0.5 * gap - 2e-3, side > 0.0 ? 1e-3 : 0.0, side > 0.0 ? 2e-3 : 0.0);   // corners off each other
    for (Vec3& v : plate.vertices) mesh.vertices.push_back(v + place);
    for (auto tet : plate.tets) { for (int& v : tet) v += first; mesh.tets.push_back(tet); }
    for (auto triangle : plate.surface) { for (int& v : triangle) v += first; mesh.surface.push_back(triangle); }
    for (int v = first; held && v < static_cast<int>(mesh.vertices.size()); ++v)
      if (side > 0.0 || mesh.vertices[v].z() < 1e-9) mesh.fixed.push_back(v);
  }
  mesh.rim = {0, 1, 2};
  return mesh;
}

struct Plates {
  Model model;
  State state;
  StepInput input;
  StepOutput out;

  explicit Plates(double gap, bool held = false) : model(buildModel(wallParams(), twoPlates(gap, held), {})) {   // gap [m]
    state = initialState(model, {kAway, Pose{Vec3(0.2, 0.2, 0.2), Quat::Identity()}});
    for (int hand = 0; hand < kHands; ++hand) input.tools[hand].pose = state.tools[hand].device;
  }
  int half() const { return static_cast<int>(model.mesh.vertices.size()) / 2; }
  double between() const {                       // [m] from the left plate's middle to the right one's, along x
    double sum = 0.0;                            // [m]
    for (int v = 0; v < half(); ++v) sum += state.tissue.position[half() + v].x() - state.tissue.position[v].x();
    return sum / half();
  }
  double fastest() const {                       // [m/s]
    double most = 0.0;                           // [m/s]
    for (const Vec3& v : state.tissue.velocity) most = std::max(most, v.norm());
    return most;
  }
};

std::vector<Pair> bruteForce(const Model& m, const State& s) {
  std::vector<Pair> found;
  for (int f = 0; f < static_cast<int>(m.surface.triangles.size()); ++f)
    for (int v : m.surface.vertices)
      if (mayTouch(m, v, f) && pairGap(m, s.tissue.position, v, f).near) found.push_back({f, v});
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Pair> searched(const Model& m, State s) {
  for (int k = 0; k < kPairRound; ++k, ++s.step) searchPairs(m, s);
  std::vector<Pair> found;
  for (int i = 0; i < s.tissue.pairCount; ++i) found.push_back({s.tissue.pairTriangle[i], s.tissue.pairVertex[i]});
  std::sort(found.begin(), found.end());
  return found;
}

/// A repeatable crumple of the wall: every vertex displaced by up to `size` [m], folded over so that far parts meet.
void crumple(const Model& m, double size, std::uint64_t seed, State& s) {
  const auto uniform = [&seed] {                 // [1] in [-1, 1)
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 11) * 0x1p-52 - 1.0;
  };
  for (std::size_t i = 0; i < s.tissue.position.size(); ++i) {
    Vec3 x = m.mesh.vertices[i];
    if (x.y() > 0.5 * kWallY) { x.y() = kWallY - x.y(); x.x() += 1.3 * kWallX; }   // the far half lies over the near half
    const double z = uniform(), y = uniform(), across = uniform();   // [1] one after the other: a call's arguments are drawn in no fixed order
    s.tissue.position[i] = x + size * Vec3(across, y, z);
  }
}

TEST(SelfContact, ARoundOfTheSearchFindsExactlyWhatBruteForceFinds) {
  StepRig rig(wallParams(), kNeedleAway);
  std::size_t most = 0;
  for (double size : {0.0, 0.3e-3, 1e-3, 3e-3, 30e-3, 1.0}) {   // [m] up to triangles stretched over thousands of cells
    for (std::uint64_t seed : {1u, 2u, 3u}) {
      crumple(rig.model, size, seed, rig.state);
      const std::vector<Pair> wanted = bruteForce(rig.model, rig.state);
      ASSERT_LE(wanted.size(), static_cast<std::size_t>(TissueState::kMaxPairs));
      EXPECT_EQ(searched(rig.model, rig.state), wanted) << "crumpled by " << size << ", seed " << seed;
      most = std::max(most, wanted.size());
    }
  }
  EXPECT_GT(most, 50u);
}

TEST(SelfContact, TheSearchLosesNoForce) {
  StepRig rig(wallParams(), kNeedleAway);
  crumple(rig.model, 1e-3, 5, rig.state);
  for (; rig.state.step < kPairRound; ++rig.state.step) searchPairs(rig.model, rig.state);
  TissueState& t = rig.state.tissue;
  for (int i = 0; i < t.pairCount; ++i) t.pairForce[i] = 1e-3 * (1 + t.pairTriangle[i]) + 1e-6 * t.pairVertex[i];
  const int count = t.pairCount;
  ASSERT_GT(count, 0);
  crumple(rig.model, 1e-3, 6, rig.state);        // elsewhere by now
  for (; rig.state.step < 2 * kPairRound; ++rig.state.step) searchPairs(rig.model, rig.state);
  int loaded = 0;
  for (int i = 0; i < t.pairCount; ++i) loaded += t.pairForce[i] > 0.0;
  EXPECT_EQ(loaded, count);
  for (int i = 0; i < t.pairCount; ++i) {
    const double given = 1e-3 * (1 + t.pairTriangle[i]) + 1e-6 * t.pairVertex[i];   // [N]
    EXPECT_TRUE(t.pairForce[i] == 0.0 || t.pairForce[i] == given) << i;
  }
}

/// Every vertex wanders by a tenth of what a list allows for, so that lists are made, serve, and give out.
TEST(SelfContact, AListFindsWhatTheCellsFindInTheSameOrder) {
  StepRig rig(wallParams(), kNeedleAway);
  crumple(rig.model, 0.6e-3, 7, rig.state);
  State& s = rig.state;
  int served = 0;
  std::size_t most = 0;
  for (int k = 0; k < 40 * kPairRound; ++k, ++s.step) {
    for (std::size_t i = 0; i < s.tissue.position.size(); ++i)
      s.tissue.position[i] += 0.1 * kPairDrift / kPairRound * Vec3(std::sin(1.0 * i), std::cos(2.0 * i), (k / 90 % 2 == 0 ? 1.0 : -1.0) * std::sin(3.0 * i));
    for (int i = 0; i < s.tissue.pairCount; i += 3) s.tissue.pairForce[i] = 1e-3 * i;   // some carry force
    State cells = s;
    for (NearPairs& list : cells.work.self.nearby) list.whole = false;
    searchPairs(rig.model, s);
    searchPairs(rig.model, cells);
    ASSERT_EQ(diff(s, cells), "") << "step " << k;
    served += s.work.self.nearby[k % kPairRound].used;
    most = std::max(most, static_cast<std::size_t>(s.tissue.pairCount));
  }
  EXPECT_GT(most, 50u);
  EXPECT_GT(served, 20 * kPairRound);            // lists did the work
  EXPECT_LT(served, 38 * kPairRound);            // and did give out
}

class ClosingPlates : public testing::TestWithParam<double> {};   // [m/s]
INSTANTIATE_TEST_SUITE_P(Speed, ClosingPlates, testing::Values(0.02, 0.1, 0.25));

/// In front of the wall's face, close to its sharp upper edge: below the plane of the edge's top, yet outside.
TEST(SelfContact, NothingBesideASharpEdgeCountsAsInside) {
  StepRig rig(wallParams(), kNeedleAway);
  const Model& m = rig.model;
  const int loose = m.surface.vertices.front();  // any vertex far from the top edge, put where a fold would bring it
  ASSERT_LT(rig.state.tissue.position[loose].z(), 0.5 * kWallZ);
  for (double inside : {-0.3e-3, 0.3e-3}) {      // [m] beyond the face
    rig.state.tissue.position[loose] = Vec3(kWallX - inside, 0.55 * kWallY, kWallZ - 0.7e-3);
    int contacts = 0;
    for (int f = 0; f < static_cast<int>(m.surface.triangles.size()); ++f) {
      if (!mayTouch(m, loose, f)) continue;
      const PairGap g = pairGap(m, rig.state.tissue.position, loose, f);
      if (g.near && g.height < 0.0) ++contacts;
    }
    EXPECT_EQ(contacts > 0, inside > 0.0) << "at " << inside;
  }
}

/// Whichever turn of the search the meeting falls into. Their middles stay a plate's thickness apart, less half a wall.
TEST_P(ClosingPlates, NeverPassThroughEachOther) {
  double nearest = 1.0;                          // [m]
  for (int turn = 0; turn < kPairRound; ++turn) {
    Plates plates(3e-3);
    plates.state.step = static_cast<std::uint64_t>(turn);
    for (int v = 0; v < 2 * plates.half(); ++v) plates.state.tissue.velocity[v].x() = (v < plates.half() ? 0.5 : -0.5) * GetParam();
    for (int k = 0; k < 400; ++k) {
      step(plates.model, plates.input, plates.state, plates.out);
      nearest = std::min(nearest, plates.between());
    }
  }
  RecordProperty("nearest_mm", std::to_string(1e3 * nearest));
  EXPECT_GT(nearest, 1.0e-3);
  EXPECT_LT(nearest, 2.5e-3);                    // they did meet
}

/// A plate that begins half a millimetre inside another, both held in places, is pushed out and comes to rest.
TEST(SelfContact, WhatIsHeldFastFlingsNothing) {
  const double depth = 0.5e-3;                   // [m]
  Plates plates(-depth, true);
  double fastest = 0.0;                          // [m/s]
  for (int k = 0; k < 2000; ++k) {
    step(plates.model, plates.input, plates.state, plates.out);
    fastest = std::max(fastest, plates.fastest());
  }
  RecordProperty("fastest_m_s", std::to_string(fastest));
  EXPECT_LT(fastest, 2.0 * depth / plates.model.params.dt);
  EXPECT_LT(plates.fastest(), 1e-4);
}

/// Near an edge a vertex can be behind the face that it came through and behind the one round the corner: pushed out of both it would go to and fro.
TEST(SelfContact, WhatIsBehindTwoFacesIsPushedThroughTheNearerOne) {
  StepRig rig(wallParams(), kNeedleAway);
  const Model& m = rig.model;
  State& s = rig.state;
  const int loose = m.surface.vertices.front();  // any vertex far from the top edge, put where a fold would bring it
  constexpr double kFace = 0.1e-3, kTop = 0.7e-3;   // [m] behind each
  s.tissue.position[loose] = Vec3(kWallX - kFace, 0.55 * kWallY, kWallZ - kTop);
  for (int k = 0; k < kPairRound; ++k, ++s.step) searchPairs(m, s);
  solveTissueContact(m, s);
  int across = 0, up = 0;                        // pairs through whose triangle it is pushed
  double deepest = 0.0;                          // [m] behind any of those that look up
  for (int i = 0; i < s.tissue.pairCount; ++i) {
    if (s.tissue.pairVertex[i] != loose) continue;
    const PairGap g = pairGap(m, s.tissue.position, loose, s.tissue.pairTriangle[i]);
    const bool looksUp = g.normal.z() > 0.9, pushed = s.tissue.pairForce[i] > 0.0;
    if (looksUp && g.near) deepest = std::max(deepest, -g.height);
    across += g.normal.x() > 0.9 && pushed;
    up += looksUp && pushed;
  }
  EXPECT_NEAR(deepest, kTop, 1e-6);              // it is there to be chosen
  EXPECT_GT(across, 0);
  EXPECT_EQ(up, 0);
}

}  // namespace
}  // namespace halsted
