/// The search for thread near thread leaves out whole pieces by their bounding spheres: it must leave out nothing that matters.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <tuple>

#include "sim/portable_math.h"
#include "sim/strand/thread_contact_search.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

using Found = std::tuple<int, int, int>;       // piece, sample, partner

/// A thread laid in a ball of loose coils, every coil near many others.
KnotRig tangle() {
  const auto coil = [](double u) {             // [1]
    const double turn = 2.0 * kPi * u;         // [rad]
    return Vec3(3e-3 * std::cos(9.0 * turn), 3e-3 * std::sin(11.0 * turn), 2e-3 * std::cos(7.0 * turn + 0.4));
  };
  return KnotRig(knotThread(), evenlySpaced(coil, knotThread().thread.segmentLength));
}

/// Every sample of every piece against every piece that it may touch, by distance alone.
std::vector<Found> allNear(const KnotRig& rig) {
  const StrandModel& m = rig.model;
  const std::vector<Vec3>& x = rig.state.position;
  const double reach = 2.0 * (1.0 + kWide) * m.radius;   // [m] of thread at rest
  std::vector<Found> found;
  for (int p = 0; p < m.nodes - 2; ++p)
    for (int q = 0; q < m.nodes - 2; ++q) {
      const int a = std::min(p, q), b = std::max(p, q);
      if (b < a + 3 || m.place[b + 1] - m.place[a + 1] <= 4.0 * m.radius) continue;
      for (int k = 0; k < rig.contactWork.samples[p]; ++k) {
        const Vec3 point = curvePoint(x, curveWeights(p, (k + 0.5) / rig.contactWork.samples[p]));
        const double place = nearestOnPiece(x, q, point);   // [1]
        if (place >= 0.0 && (point - curvePoint(x, curveWeights(q, place))).norm() <= reach) found.emplace_back(p, k, q);
      }
    }
  std::sort(found.begin(), found.end());
  return found;
}

/// What is nearest lies square to the curve, however strongly that bends: a place that is off by a little turns the normal of a contact.
TEST(ThreadSearch, WhatIsNearestLiesSquareToTheCurve) {
  constexpr double kSegment = 0.3e-3;          // [m]
  std::mt19937 generator(1);
  const auto random = [&] { return 2.0 * generator() / 4294967296.0 - 1.0; };   // [1]
  const auto any = [&] { return Vec3(random(), random(), random()); };   // [1]
  int found = 0;
  double worst = 0.0;                          // [1] of a piece
  for (int i = 0; i < 20000; ++i) {
    const Vec3 ahead = (Vec3::UnitX() + 0.8 * any()).normalized();   // [1]
    const std::array<Vec3, 3> x = {Vec3::Zero(), kSegment * Vec3::UnitX(), kSegment * (Vec3::UnitX() + ahead)};   // [m]
    const Vec3 point = x[1] + 2.0 * kSegment * any();   // [m]
    const double v = nearestOnPiece(x, 0, point);   // [1]
    if (v < 0.0) continue;
    ++found;
    const Vec3 along = (1.0 - v) * (x[1] - x[0]) + v * (x[2] - x[1]);   // [m]
    worst = std::max(worst, std::abs(along.dot(curvePoint(x, curveWeights(0, v)) - point)) / along.squaredNorm());
  }
  EXPECT_GT(found, 3000);
  EXPECT_LT(worst, 1e-9);
}

/// Four points at a time or one after the other: bent pieces, straight ones, and one without length.
TEST(ThreadSearch, FindsTheSamePlacesToTheBitFourAtATime) {
  if (widestLanes() == LanePath::kSerial) GTEST_SKIP() << "this processor has no other way";
  constexpr double kSegment = 0.3e-3;          // [m]
  std::mt19937 generator(2);
  const auto random = [&] { return 2.0 * generator() / 4294967296.0 - 1.0; };   // [1]
  const auto any = [&] { return Vec3(random(), random(), random()); };   // [1]
  int found = 0, outside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double bend = i % 5 == 0 ? 0.0 : 0.8, size = i % 97 == 0 ? 0.0 : kSegment;   // [1], [m]
    const Vec3 ahead = (Vec3::UnitX() + bend * any()).normalized();   // [1]
    const std::array<Vec3, 3> x = {Vec3::Zero(), size * Vec3::UnitX(), size * (Vec3::UnitX() + ahead)};   // [m]
    PointRow points;
    const int count = 1 + i % PointRow::kMost;
    for (int k = 0; k < count; ++k) points.set(k, k % 7 == 3 ? 0.5 * (x[0] + x[1]) : Vec3(x[1] + 2.0 * kSegment * any()));
    const Sphere within{x[1], 2.0 * kSegment};
    std::array<double, PointRow::kMost> serial, wide;   // [1]
    nearestPlaces(pieceShape(x, 0), points, count, within, serial, LanePath::kSerial);
    nearestPlaces(pieceShape(x, 0), points, count, within, wide, LanePath::kWide);
    for (int k = 0; k < count; ++k) {
      const double one = (points.at(k) - x[1]).norm() <= within.reach ? nearestOnPiece(x, 0, points.at(k)) : -1.0;   // [1]
      ASSERT_EQ(std::bit_cast<std::uint64_t>(serial[k]), std::bit_cast<std::uint64_t>(one)) << i << ' ' << k;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(wide[k]), std::bit_cast<std::uint64_t>(one)) << i << ' ' << k;
      found += one >= 0.0;
      outside += (points.at(k) - x[1]).norm() > within.reach;
    }
  }
  EXPECT_GT(found, 30000);
  EXPECT_GT(outside, 30000);
}

TEST(ThreadSearch, FindsEveryPairThatIsNear) {
  KnotRig rig = tangle();
  ThreadTouch touch{rig.contacts, rig.contactWork};
  ASSERT_TRUE(searchNear(rig.model, rig.state, rig.dt, touch));
  std::vector<Found> found;
  for (const NearPair& pair : rig.contactWork.near) found.emplace_back(pair.piece, pair.sample, pair.partner);
  std::sort(found.begin(), found.end());
  const std::vector<Found> all = allNear(rig);
  EXPECT_GT(all.size(), 200u);
  EXPECT_EQ(found, all);
}

/// A rod across the ball: contacts at every sample that lies on it, and only there.
TEST(ThreadSearch, FindsEverySampleAtASolid) {
  KnotRig rig = tangle();
  ThreadSolid rod;
  rod.a = rod.fromA = Vec3(-4e-3, 0.3e-3, 0.1e-3);
  rod.b = rod.fromB = Vec3(4e-3, -0.2e-3, 0.4e-3);
  rod.radius = 0.8e-3;
  rig.solids.push_back(rod);
  rig.contactWork.solids = rig.solids;
  ThreadTouch touch{rig.contacts, rig.contactWork};
  findThreadContacts(rig.model, rig.state, rig.dt, touch);
  std::vector<int> found, all;                 // samples
  for (const TouchingPoint& c : rig.contactWork.points)
    if (c.solid) found.push_back(c.record.sample);
  for (int p = 0; p < rig.model.nodes - 2; ++p)
    for (int k = 0; k < rig.contactWork.samples[p]; ++k) {
      const Vec3 point = curvePoint(rig.state.position, curveWeights(p, (k + 0.5) / rig.contactWork.samples[p])), along = rod.b - rod.a;
      const double f = std::clamp((point - rod.a).dot(along) / along.squaredNorm(), 0.0, 1.0);   // [1]
      if ((point - rod.a - f * along).norm() <= rod.radius + 1.5 * rig.model.radius) all.push_back(p * kMostSamples + k);
    }
  EXPECT_GT(all.size(), 20u);
  EXPECT_EQ(found, all);
}

}  // namespace
}  // namespace halsted
