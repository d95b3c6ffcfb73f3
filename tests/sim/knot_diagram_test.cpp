/// What was tied is read from the thread's course: on generated knots, also bent, turned, shaken and mirrored.
#include <gtest/gtest.h>

#include <random>

#include "sim/portable_math.h"
#include "sim/strand/knot_diagram.h"
#include "sim/strand/tool_winding.h"
#include "tests/sim/knot_tie.h"

namespace halsted {
namespace {

std::vector<Vec3> knot(std::vector<int> throws) { return LooseKnot(throws, {}).nodes(0.3e-3); }

struct Tied { std::vector<int> halfTwists; const char* notation; const char* name; long long determinant; };

std::ostream& operator<<(std::ostream& out, const Tied& t) { return out << t.notation; }

class KnotReadingOf : public testing::TestWithParam<Tied> {};

/// Bends and shears everything smoothly, then turns it: no strand passes another.
std::vector<Vec3> perturbed(std::vector<Vec3> x, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> number(-1.0, 1.0);
  double drawn[6];                             // [1] one after the other: the order of a call's arguments is each compiler's own
  for (double& d : drawn) d = number(random);
  const Quat turn = Quat(drawn[0], drawn[1], drawn[2], drawn[3]).normalized();
  const double a = drawn[4], b = drawn[5];     // [1]
  for (Vec3& p : x) {
    const double u = p.x() / 8e-3, v = p.y() / 8e-3;     // [1]
    p = turn * Vec3(p.x() + 2e-3 * a * std::sin(v), p.y() + 2e-3 * b * std::sin(1.3 * u + v), p.z() + 3e-3 * std::sin(a * u + 2.0 * b * v));
  }
  return x;
}

TEST_P(KnotReadingOf, NamesTheGeneratedKnot) {
  const KnotReading r = readKnot(knot(GetParam().halfTwists));
  EXPECT_TRUE(r.complete);
  EXPECT_EQ(surgicalNotation(r), GetParam().notation);
  EXPECT_EQ(knotName(r), GetParam().name);
}

TEST_P(KnotReadingOf, DoesNotDependOnBendingOrOnTheView) {
  constexpr unsigned kSeeds = 500;
  unsigned right = 0;
  const std::vector<Vec3> tied = knot(GetParam().halfTwists);
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const KnotReading r = readKnot(perturbed(tied, seed));
    right += surgicalNotation(r) == GetParam().notation ? 1 : 0;
    if (surgicalNotation(r) != GetParam().notation) std::printf("seed %u: %s\n", seed, surgicalNotation(r).c_str());
  }
  EXPECT_EQ(right, kSeeds);
}

TEST_P(KnotReadingOf, IsTheSameInAMirrorAndFromTheOtherEnd) {
  std::vector<Vec3> x = knot(GetParam().halfTwists);
  std::reverse(x.begin(), x.end());
  EXPECT_EQ(surgicalNotation(readKnot(x)), GetParam().notation);
  for (Vec3& p : x) p.z() = -p.z();
  const KnotReading mirrored = readKnot(x), own = readKnot(knot(GetParam().halfTwists));
  EXPECT_EQ(surgicalNotation(mirrored), GetParam().notation);
  for (std::size_t k = 0; k < own.throws.size(); ++k) EXPECT_EQ(mirrored.throws[k].sign, -own.throws[k].sign);
}

/// An invariant that knows nothing of throws agrees, on diagrams that are not reduced.
TEST_P(KnotReadingOf, HasTheDeterminantOfItsThrows) {
  for (const Vec3& view : {Vec3(0.1, 0.2, 1.0), Vec3(1.0, 0.4, 0.3), Vec3(0.3, 1.0, 0.5)}) {
    const KnotDiagram d = projectThread(straightened(perturbed(knot(GetParam().halfTwists), 3)), view);
    EXPECT_EQ(knotDeterminant(d), GetParam().determinant) << d.crossings() << " crossings";
  }
}

INSTANTIATE_TEST_SUITE_P(Throws, KnotReadingOf, testing::Values(
    Tied{{1}, "", "none", 1}, Tied{{3}, "1", "half hitch", 3}, Tied{{3, -3}, "1=1", "square", 9}, Tied{{-3, 3}, "1=1", "square", 9},
    Tied{{3, 3}, "1x1", "granny", 9}, Tied{{5, -3, 3}, "2=1=1", "surgeon's", 45}, Tied{{5, -3}, "2=1", "2=1", 15},
    Tied{{3, -3, -3}, "1=1x1", "1=1x1", 27}, Tied{{3, 3, -3}, "1x1=1", "1x1=1", 27}, Tied{{5, 5}, "2x2", "2x2", 25}));

TEST(KnotReading, StraightAndCoiledThreadIsNoKnot) {
  std::vector<Vec3> coil;
  for (int i = 0; i < 300; ++i) coil.push_back(1e-3 * Vec3(3.0 * std::cos(0.1 * i), 3.0 * std::sin(0.1 * i), 0.02 * i));
  EXPECT_EQ(knotName(readKnot(coil)), "none");
  EXPECT_EQ(straightened(coil).size(), 2u);
}

TEST(KnotReading, TwoKnotsOnOneThreadAreNotOneKnot) {
  std::vector<Vec3> x = knot({3});
  const std::vector<Vec3> second = x;
  const Vec3 shift = x.back() - second.front() + Vec3(-5e-3, 0.0, 0.0);
  for (const Vec3& p : second) x.push_back(p + shift + Vec3(0.0, 30e-3, 0.0));
  const KnotReading r = readKnot(x);
  EXPECT_EQ(r.throws.size(), 2u);
  EXPECT_FALSE(r.complete);
}

/// A double throw, seen with the ends across each other: neither move takes their crossing out while the throw is inside it. In `lembert` the throw so
/// seen did not count as read, a next one that had not come was not missed, and the one after it was wound for a granny.
KnotDiagram doubleThrowWithEndsAcross(int sign, bool over) {   // [1] of the ends' crossing
  KnotDiagram d;
  d.sign = {sign, 1, 1, 1, 1, 1};
  d.code.push_back({0, over});
  for (const bool back : {false, true})
    for (int c = 1; c <= 5; ++c) d.code.push_back({c, (c % 2 == 0) == back});
  d.code.push_back({0, !over});
  return d;
}

TEST(KnotReading, EndsAcrossEachOtherBelongToNoThrowAndHideNone) {
  for (const int sign : {-1, 1})
    for (const bool over : {false, true}) {
      KnotDiagram d = doubleThrowWithEndsAcross(sign, over);
      EXPECT_EQ(knotDeterminant(d), 5);
      reduceDiagram(d);
      EXPECT_EQ(d.crossings(), 6);
      const KnotReading r = takeThrows(d);
      EXPECT_TRUE(r.complete);
      EXPECT_EQ(surgicalNotation(r), "2");
    }
}

/// Wound thread that crosses its last turn at the end of each.
std::vector<Vec3> helix(int turns, double pitch) {   // [1], [m per turn]
  constexpr double kBeyond = 0.4;              // [rad]
  const double all = 2.0 * kPi * std::abs(turns) + 2.0 * kBeyond, sense = turns < 0 ? -1.0 : 1.0;   // [rad], [1]
  std::vector<Vec3> x;
  for (int i = 0; i <= 401; ++i) {
    const double angle = all * i / 401.0 - kBeyond;   // [rad]
    const double r = 2e-3 * (1.0 + 0.1 * std::sin(0.5 * angle));   // [m]
    x.push_back(Vec3(r * std::cos(sense * angle + 0.5), r * std::sin(sense * angle + 0.5), pitch * (angle + kBeyond) / (2.0 * kPi)));
  }
  return x;
}

/// Thread that comes from one side, goes round the tool and leaves over its own path.
std::vector<Vec3> thrownLoop(double rise) {   // [m]
  std::vector<Vec3> fine{1e-3 * Vec3(4.0, -2.0, 0.0)};
  for (int degrees = 60; degrees <= 300; degrees += 2) {
    const double angle = degrees * kPi / 180.0;   // [rad]
    fine.push_back(2e-3 * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  fine.push_back(1e-3 * Vec3(4.0, 2.0, 0.0));
  std::vector<Vec3> x = evenlySpaced(fine, 0.15e-3);
  for (std::size_t i = 0; i < x.size(); ++i) x[i].z() = rise * i / x.size();
  return x;
}

TEST(ToolLoop, IsFoundByProjectionWhenTheThreadGoesRound) {
  const ToolLoop loop = findToolLoop(thrownLoop(0.3e-3), {}, 0.5e-3);
  EXPECT_TRUE(loop.crosses);
  EXPECT_TRUE(loop.valid());
}
TEST(ToolLoop, BesideTheToolFailsTheEvenOddCheck) {
  std::vector<Vec3> x = thrownLoop(0.3e-3);
  for (Vec3& p : x) p.x() += 6e-3;
  const ToolLoop loop = findToolLoop(x, {}, 0.5e-3);
  EXPECT_TRUE(loop.crosses);
  EXPECT_FALSE(loop.encirclesTool());
  EXPECT_FALSE(loop.valid());
}
TEST(ToolLoop, WithEndsFarApartAlongTheToolFailsTheDistanceCheck) {
  const ToolLoop loop = findToolLoop(thrownLoop(6e-3), {}, 0.5e-3);
  EXPECT_TRUE(loop.encirclesTool());
  EXPECT_FALSE(loop.closed);
}
TEST(ToolLoop, OffTheToolIsNone) {
  EXPECT_TRUE(findToolLoop(thrownLoop(0.3e-3), {Vec3::Zero(), Vec3::UnitZ(), 5e-3, 10e-3}, 0.5e-3).valid());
  EXPECT_FALSE(findToolLoop(thrownLoop(0.3e-3), {Vec3::Zero(), Vec3::UnitZ(), 1e-3, 10e-3}, 0.5e-3).crosses) << "2 mm away";
  EXPECT_FALSE(findToolLoop(thrownLoop(0.3e-3), {Vec3(0.0, 0.0, 1e-3), Vec3::UnitZ(), 5e-3, 10e-3}, 0.5e-3).crosses) << "below the tip";
}
TEST(ToolLoop, ThreadThatOnlyPassesIsNotWound) {
  std::vector<Vec3> passing;
  for (int i = -50; i <= 50; ++i) passing.push_back(Vec3(1.5e-3, 0.1e-3 + 0.2e-3 * i, 0.0));
  EXPECT_EQ(woundTurns(passing, {}, 5e-3), 0);
}
TEST(ToolLoop, WoundThreadIsCountedWithItsSign) {
  for (int turns : {-3, -2, -1, 1, 2, 3}) EXPECT_EQ(woundTurns(helix(turns, 0.3e-3), {}, 0.5e-3), turns);
}
TEST(ToolLoop, TurnsFarApartAlongTheToolAreNone) { EXPECT_EQ(woundTurns(helix(3, 6e-3), {}, 0.5e-3), 0); }

}  // namespace
}  // namespace halsted
