/// Law S3 of the fit, its errors, its report, and real surfaces when HALSTED_DATA is set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "scenes/harmonics/fit.h"
#include "scenes/harmonics/layers.h"
#include "scenes/harmonics/region.h"
#include "scenes/input_text.h"
#include "scenes/mesh_path.h"
#include "tests/scenes/surface_makers.h"

namespace halsted::scenes {
namespace {

using ::testing::HasSubstr;

constexpr double kTurn = 6.28318530717958648;   // [rad]

/// Even samples of the surface r(u).
template <class Shape> FitSamples sampled(int count, const Shape& r) {
  FitSamples s;
  s.unit = spreadDirections(count);
  for (const Vec3& u : s.unit) s.position.push_back(r(u));
  s.weight.assign(count, 1.0);
  return s;
}

template <class Shape> double worstError(const HarmonicSurface& surface, const Shape& r) {   // [m]
  double worst = 0.0;                          // [m]
  for (const Vec3& u : spreadDirections(777)) worst = std::max(worst, (positionAt(surface, u) - r(u)).norm());
  return worst;
}

template <class Shape> double rmsError(const HarmonicSurface& surface, const Shape& r) {   // [m]
  double sum = 0.0;                            // [m^2]
  const std::vector<Vec3> units = spreadDirections(5000);
  for (const Vec3& u : units) sum += (positionAt(surface, u) - r(u)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(units.size()));
}

double y43(const Vec3& u) {                    // [1]
  std::vector<double> values(harmonicCount(4));   // [1]
  harmonics(harmonicTables(4), u, values);
  return values[harmonicIndex(4, 3)];
}

std::string fitRefusal(const std::function<void()>& act) {
  try { act(); } catch (const InputError& error) { return error.what(); }
  return "nothing refused";
}

TEST(HarmonicFit, SphereAndEllipsoidAreExactAtOrderOneAndStaySoAbove) {
  const auto sphere = [](const Vec3& u) { return Vec3(0.2 * u); };
  const auto ellipsoid = [](const Vec3& u) { return Vec3(0.3 * u.x(), 0.2 * u.y() + 0.01, 0.1 * u.z()); };
  for (int order : {1, 2, 8, 20, 30}) {
    const int samples = 3 * harmonicCount(order);
    EXPECT_LT(worstError(fitHarmonics(sampled(samples, sphere), order, "sphere").surface, sphere), 1e-12) << order;
    EXPECT_LT(worstError(fitHarmonics(sampled(samples, ellipsoid), order, "ellipsoid").surface, ellipsoid), 1e-12) << order;
  }
}

TEST(HarmonicFit, ARadialHarmonicIsExactOnceItsProductsFit) {   // u times Y_43 has parts of order 3 and 5
  const auto shape = [](const Vec3& u) { return Vec3((0.2 + 0.03 * y43(u)) * u); };
  EXPECT_LT(worstError(fitHarmonics(sampled(400, shape), 5, "shape").surface, shape), 1e-12);
  EXPECT_GT(worstError(fitHarmonics(sampled(400, shape), 4, "shape").surface, shape), 1e-4);
}

TEST(HarmonicFit, ErrorFallsGeometricallyForAnAnalyticShape) {
  const auto shape = [](const Vec3& u) { return Vec3(0.2 * u / (1.0 + 0.4 * u.x() + 0.2 * u.z() * u.y())); };
  std::vector<double> error;                   // [m]
  for (int order : {4, 8, 12, 16}) error.push_back(worstError(fitHarmonics(sampled(4 * harmonicCount(order), shape), order, "shape").surface, shape));
  const double first = error[1] / error[0], second = error[2] / error[1], third = error[3] / error[2];   // [1]
  for (double ratio : {first, second, third}) EXPECT_LT(ratio, 0.2);
  EXPECT_NEAR(std::log(second) / std::log(first), 1.0, 0.35);   // equal ratios: a straight line in a logarithmic picture
  EXPECT_NEAR(std::log(third) / std::log(second), 1.0, 0.35);
}

TEST(HarmonicFit, ErrorFallsByAPowerForACreasedShape) {   // a cone-like crease at the equator
  const auto shape = [](const Vec3& u) { return Vec3(0.2 * u * (1.0 - 0.3 * std::abs(u.z()))); };
  std::vector<double> error;                   // [m]
  for (int order : {5, 10, 20}) error.push_back(rmsError(fitHarmonics(sampled(4 * harmonicCount(order), shape), order, "shape").surface, shape));
  for (int k = 0; k < 2; ++k) {
    const double power = std::log2(error[k] / error[k + 1]);   // [1]
    EXPECT_GT(power, 1.0);
    EXPECT_LT(power, 2.0);
  }
}

TEST(HarmonicFit, ConditionIsNearOneForEvenSamplesAndGrowsWithAGap) {
  const auto sphere = [](const Vec3& u) { return Vec3(0.2 * u); };
  const FitSamples even = sampled(2000, sphere);
  FitSamples gap, half;
  for (std::size_t k = 0; k < even.unit.size(); ++k) {
    for (FitSamples* part : {&gap, &half}) {   // no samples on a small cap, none on a large one
      if (even.unit[k].z() > (part == &gap ? 0.9 : 0.0)) continue;
      part->unit.push_back(even.unit[k]);
      part->position.push_back(even.position[k]);
      part->weight.push_back(1.0);
    }
  }
  const double good = fitHarmonics(even, 10, "even").report.condition, bad = fitHarmonics(gap, 10, "gap").report.condition;   // [1]
  EXPECT_LT(good, 1.2);
  EXPECT_GT(bad, 10.0 * good);
  EXPECT_THAT(fitRefusal([&] { fitHarmonics(half, 20, "half"); }), HasSubstr("half: order 20 is too high"));
}

TEST(SphereMap, LaysAnEllipsoidEvenlyAndOneToOne) {
  const Surface s = superellipsoid({Vec3(0.2, 0.1, 0.05), 2.0, 24});
  const SphereMap map = mapToSphere(s, "ellipsoid");
  EXPECT_EQ(map.flipped, 0);
  EXPECT_LT(map.areaSpread, 0.1);
  for (const Vec3& u : map.unit) EXPECT_NEAR(u.norm(), 1.0, 1e-12);
}

TEST(SphereMap, TurnsAnInsideOutSurface) {
  Surface s = superellipsoid({Vec3(0.1, 0.1, 0.05), 2.0, 12});
  for (auto& t : s.triangles) std::swap(t[0], t[1]);
  const HarmonicFit fit = fitSurface(s, 8, "turned");
  for (const Vec3& u : spreadDirections(50)) {
    const SurfaceFrame f = frameAt(fit.surface, u);
    EXPECT_GT(f.normal.dot(f.position), 0.0);  // outward
  }
}

TEST(HarmonicFit, RefusesWhatIsNotLikeASphereInOneLine) {
  const Surface sphere = superellipsoid({Vec3(0.1, 0.1, 0.1), 2.0, 6});
  const Surface open = halsted::testing::without(sphere, [](const Vec3& p) { return p.z() > 0.08; });
  EXPECT_THAT(fitRefusal([&] { fitSurface(open, 3, "skin.obj"); }), HasSubstr("skin.obj: the surface is open"));
  Surface two = sphere;                        // two spheres
  for (const Vec3& p : sphere.vertices) two.vertices.push_back(p + Vec3(1, 0, 0));
  for (const auto& t : sphere.triangles) {
    const int n = static_cast<int>(sphere.vertices.size());
    two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  EXPECT_THAT(fitRefusal([&] { fitSurface(two, 3, "skin.obj"); }), HasSubstr("2 pieces"));
  Surface torus;                               // one handle
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 8; ++j) {
      const double a = i * kTurn / 12, b = j * kTurn / 8, r = 0.1 + 0.03 * std::cos(b);   // [rad], [m]
      torus.vertices.push_back(Vec3(r * std::cos(a), r * std::sin(a), 0.03 * std::sin(b)));
      const int here = 8 * i + j, up = 8 * i + (j + 1) % 8, right = 8 * ((i + 1) % 12) + j, both = 8 * ((i + 1) % 12) + (j + 1) % 8;
      torus.triangles.insert(torus.triangles.end(), {{here, right, both}, {here, both, up}});
    }
  EXPECT_THAT(fitRefusal([&] { fitSurface(torus, 3, "ring.obj"); }), HasSubstr("1 handles"));
  EXPECT_THAT(fitRefusal([&] { fitSurface(superellipsoid({Vec3(0.1, 0.1, 0.1), 2.0, 4}), 30, "few.obj"); }), HasSubstr("needs at least 1922 samples"));
  EXPECT_THAT(fitRefusal([&] { fitSurface(sphere, 99, "s.obj"); }), HasSubstr("outside 1 to"));
}

TEST(Layers, LieAtTheirDepthAndRefuseToFold) {
  const HarmonicSurface skin = fitSurface(superellipsoid({Vec3(0.1, 0.1, 0.04), 4.0, 30}), 12, "slab").surface;
  const std::vector<HarmonicSurface> nested = nestedSurfaces(skin, {0.0, 0.8e-3, 9.2e-3}, "slab");
  ASSERT_EQ(nested.size(), 3u);
  for (const Vec3& u : spreadDirections(60)) {
    const SurfaceFrame top = frameAt(skin, u);
    EXPECT_NEAR((positionAt(nested[1], u) - top.position).dot(-top.normal), 0.8e-3, 0.05e-3);
    EXPECT_NEAR((positionAt(nested[2], u) - top.position).dot(-top.normal), 9.2e-3, 0.5e-3);
  }
  EXPECT_THAT(fitRefusal([&] { nestedSurfaces(skin, {0.0, 2e-3, 1e-3}, "slab"); }), HasSubstr("negative thickness"));
  EXPECT_THAT(fitRefusal([&] { nestedSurfaces(skin, {0.0, 0.2}, "slab"); }), HasSubstr("folds"));
}

Surface dataSurface(const std::string& file, double scale) {   // scale [m per unit]
  return readSurface(dataFolder() + "/skin/" + file, scale);
}

TEST(RealSkin, TorsoFitsToAMillimetreAtOrderTwenty) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const HarmonicFit fit = fitSurface(dataSurface("patient-00020-torso.vtk", 0.66e-3), 20, "torso");
  EXPECT_LT(fit.report.rms, 1.0e-3);           // of a surface 0.5 m long; the largest is at the edges of the scan
  EXPECT_LT(fit.report.largest, 10e-3);
  EXPECT_LT(fit.report.condition, 2.0);
  EXPECT_EQ(fit.report.flipped, 0);
}

TEST(RealSkin, LowerLegCutFromABodyFitsToAThirdOfAMillimetre) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const Surface body = dataSurface("VH_M_Skin_40k.obj", 1e-3);
  const Surface leg = cutRegion(body, {{Vec3(0, -0.80, 0), Vec3(0, 1, 0)}, {Vec3(0, -0.45, 0), Vec3(0, -1, 0)}}, Vec3(0.19, -0.6, -0.07), "leg");
  const HarmonicFit fit = fitSurface(leg, 20, "leg");
  EXPECT_LT(fit.report.rms, 0.35e-3);
  EXPECT_LT(fit.report.condition, 2.0);
  EXPECT_EQ(fit.report.flipped, 0);
  EXPECT_THAT(fitRefusal([&] { cutRegion(body, {{Vec3(0, 5, 0), Vec3(0, 1, 0)}}, Vec3::Zero(), "leg"); }), HasSubstr("leave nothing"));
}

}  // namespace
}  // namespace halsted::scenes
