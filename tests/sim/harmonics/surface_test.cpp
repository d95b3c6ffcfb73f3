/// What a surface of harmonics is, exactly: spheres, ellipsoids, their normals, bends and nearest points.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/harmonics/surface.h"
#include "sim/portable_math.h"

namespace halsted {
namespace {

/// x = a X, y = b Y, z = c Z of a unit vector: first-order harmonics only (law S3).
HarmonicSurface ellipsoid(const Vec3& axes, int order = 1) {   // axes [m]
  std::vector<Vec3> c(harmonicCount(order), Vec3::Zero());
  const double k = std::sqrt(4.0 * kPi / 3.0);  // [1]
  c[harmonicIndex(1, 1)] = Vec3(k * axes.x(), 0, 0);
  c[harmonicIndex(1, -1)] = Vec3(0, k * axes.y(), 0);
  c[harmonicIndex(1, 0)] = Vec3(0, 0, k * axes.z());
  return harmonicSurface(order, c);
}

/// An ellipsoid with terms of every order up to 15: nothing special about it.
HarmonicSurface bumpy() {
  HarmonicSurface s = ellipsoid(Vec3(0.3, 0.2, 0.25), 15);
  std::vector<Vec3> c = coefficients(s);
  for (std::size_t i = 4; i < c.size(); ++i) c[i] = 0.01 / static_cast<double>(i) * Vec3(std::sin(i * 1.3), std::cos(i * 0.7), std::sin(i * 2.9));
  return harmonicSurface(15, c);
}

std::vector<Vec3> someUnits() {
  std::vector<Vec3> units{Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, -1, 0)};
  for (int i = 0; i < 40; ++i) units.push_back(Vec3(std::sin(i * 1.1), std::cos(i * 2.3), std::sin(i * 0.37 + 1)).normalized());
  return units;
}

TEST(HarmonicSurface, EllipsoidIsExactAtOrderOne) {
  const Vec3 axes(0.3, 0.2, 0.1);
  const HarmonicSurface s = ellipsoid(axes);
  for (const Vec3& u : someUnits()) EXPECT_LT((positionAt(s, u) - axes.cwiseProduct(u)).norm(), 1e-15);
}

TEST(HarmonicSurface, SumsTheBasis) {
  const HarmonicSurface s = bumpy();
  const std::vector<Vec3> c = coefficients(s);
  std::vector<double> values(c.size());        // [1]
  for (const Vec3& u : someUnits()) {
    harmonics(s.tables, u, values);
    Vec3 sum = Vec3::Zero();                   // [m]
    for (std::size_t i = 0; i < c.size(); ++i) sum += values[i] * c[i];
    EXPECT_LT((positionAt(s, u) - sum).norm(), 1e-14);
    EXPECT_LT((frameAt(s, u).position - sum).norm(), 1e-14);
  }
}

TEST(HarmonicSurface, NormalIsTheEllipsoidsOwn) {
  const Vec3 axes(0.3, 0.2, 0.1);
  const HarmonicSurface s = ellipsoid(axes);
  for (const Vec3& u : someUnits()) EXPECT_LT((frameAt(s, u).normal - u.cwiseQuotient(axes).normalized()).norm(), 1e-13);
}

TEST(HarmonicSurface, TangentsAndBendAreTheDerivatives) {
  const HarmonicSurface s = bumpy();
  const double h = 1e-4;                       // [rad]
  for (const Vec3& u : someUnits()) {
    const SurfaceFrame f = frameAt(s, u);
    const SurfaceBend bend = bendAt(s, f);
    const auto at = [&](double a, double b) {  // [rad] along the great circle in the direction (a, b)
      const double angle = std::sqrt(a * a + b * b);   // [rad]
      const Vec3 way = angle > 0.0 ? Vec3((a * f.direction1 + b * f.direction2) / angle) : f.direction1;
      return positionAt(s, Vec3(std::cos(angle) * u + std::sin(angle) * way));
    };
    EXPECT_LT(((at(h, 0) - at(-h, 0)) / (2 * h) - f.tangent1).norm(), 1e-6);
    EXPECT_LT(((at(0, h) - at(0, -h)) / (2 * h) - f.tangent2).norm(), 1e-6);
    EXPECT_LT(((at(h, 0) - 2 * f.position + at(-h, 0)) / (h * h) - bend.along11).norm(), 1e-5);
    EXPECT_LT(((at(0, h) - 2 * f.position + at(0, -h)) / (h * h) - bend.along22).norm(), 1e-5);
    EXPECT_LT(((at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h) - bend.along12).norm(), 1e-5);
  }
}

TEST(HarmonicSurface, NearestPointHasTheGapAlongTheNormal) {
  const HarmonicSurface s = bumpy();
  for (const Vec3& u : someUnits()) {
    const SurfaceFrame f = frameAt(s, u);
    for (double depth : {-0.02, -1e-3, 0.0, 0.01}) {   // [m]
      const Vec3 start = (u + 0.1 * f.direction1 - 0.05 * f.direction2).normalized();
      const SurfaceFrame found = nearestPoint(s, f.position + depth * f.normal, start, 40);
      EXPECT_LT((found.position - f.position).norm(), 1e-9) << depth;
    }
  }
}

TEST(HarmonicSurface, NearestPointFollowsAHandWithTwoSteps) {
  const HarmonicSurface s = bumpy();
  SurfaceFrame f = frameAt(s, Vec3(0, 0, 1));
  double worst = 0.0;                          // [m]
  for (int k = 0; k < 400; ++k) {              // 0.25 m/s along the surface, 2 mm below it
    const Vec3 u = Vec3(std::sin(0.001 * k), 0.1 * std::sin(0.01 * k), std::cos(0.001 * k)).normalized();
    const SurfaceFrame exact = frameAt(s, u);
    f = nearestPoint(s, exact.position - 0.002 * exact.normal, f.unit, 2);
    worst = std::max(worst, (f.position - exact.position).norm());
  }
  EXPECT_LT(worst, 1e-7);
}

TEST(HarmonicSurface, ALineMeetsItWhereItShould) {
  const HarmonicSurface s = bumpy();
  for (const Vec3& u : someUnits()) {
    const SurfaceFrame f = frameAt(s, u);
    const Vec3 way = (-f.normal + 0.5 * f.tangent1.normalized()).normalized();
    const LineHit hit = meetLine(s, {f.position - 0.03 * way, way}, (u + 0.1 * f.direction2).normalized());
    ASSERT_TRUE(hit.found);
    EXPECT_NEAR(hit.distance, 0.03, 1e-9);
  }
  const SurfaceFrame f = frameAt(s, Vec3(0, 0, 1));
  EXPECT_FALSE(meetLine(s, {f.position + 0.2 * f.normal, f.tangent1.normalized()}, Vec3(0, 0, 1)).found);
}

TEST(HarmonicSurface, RefusesAWrongNumberOfCoefficients) {
  EXPECT_THROW(harmonicSurface(2, std::vector<Vec3>(8, Vec3::Zero())), std::invalid_argument);
}

}  // namespace
}  // namespace halsted
