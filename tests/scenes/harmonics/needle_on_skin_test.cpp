/// A needle goes through skin, fat and muscle of fitted surfaces: the paper's slab, and real skin when HALSTED_DATA is set.
#include <gtest/gtest.h>

#include "scenes/harmonics/fit.h"
#include "scenes/harmonics/layers.h"
#include "scenes/harmonics/region.h"
#include "scenes/mesh_path.h"
#include "sim/needling/needling.h"

namespace halsted::scenes {
namespace {

/// Depth along the skin's normal at which each layer gives way, at one place of the sphere.  [m]
std::vector<double> punctureDepths(const Surface& skin, const Vec3& place) {
  const HarmonicFit fit = fitSurface(skin, 15, "skin");
  const NeedlingParams params;
  const double fat = params.layers[0].thickness, muscle = fat + params.layers[1].thickness;   // [m]
  const std::vector<HarmonicSurface> nested = nestedSurfaces(fit.surface, {0.0, fat, muscle}, "skin");
  const NeedlingModel model = needlingModel(params, {nested[0], nested[1], nested[2]});
  NeedlingState state = needlingState(model);
  NeedlingOutput out;
  NeedlingInput input;
  const SurfaceFrame top = frameAt(nested[0], place.normalized());
  state.skinUnit = state.fingerUnit = top.unit;
  input.finger.pose.position = top.position + 0.05 * top.normal;
  input.needle.pose.orientation = turnOnto(Vec3::UnitZ(), top.normal);
  std::vector<double> depths;                  // [m]
  for (int k = -100; k < 3000; ++k) {          // 15 mm at 5 mm/s
    input.needle.pose.position = top.position - 5e-6 * k * top.normal;
    input.needle.velocity = -5e-3 * top.normal;
    stepNeedling(model, input, state, out);
    EXPECT_LT(out.needle.force.norm(), 3.3);   // what a desktop device can give
    if (out.punctured >= 0) depths.push_back(5e-6 * k);
  }
  return depths;
}

void expectThreeLayers(const Surface& skin, const Vec3& place) {
  const std::vector<double> depths = punctureDepths(skin, place);   // [m]
  ASSERT_EQ(depths.size(), 3u);
  EXPECT_NEAR(depths[0], 0.52e-3, 0.02e-3);    // 0.3 N on 580 N/m
  EXPECT_NEAR(depths[1], 0.8e-3 + 0.15e-3, 0.1e-3);
  EXPECT_NEAR(depths[2], 9.2e-3 + 0.18e-3, 0.4e-3);
}

TEST(NeedleOnSkin, GoesThroughTheLayersOfASlab) {
  expectThreeLayers(superellipsoid({Vec3(0.1, 0.1, 0.05), 4.0, 30}), Vec3(0, 0, 1));
}

TEST(NeedleOnSkin, GoesThroughTheLayersOfATorso) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  expectThreeLayers(readSurface(dataFolder() + "/skin/patient-00020-torso.vtk", 0.66e-3), Vec3(0, -1, 0));
}

TEST(NeedleOnSkin, GoesThroughTheLayersOfALowerLeg) {
  if (dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  const Surface body = readSurface(dataFolder() + "/skin/VH_M_Skin_40k.obj", 1e-3);
  expectThreeLayers(cutRegion(body, {{Vec3(0, -0.80, 0), Vec3(0, 1, 0)}, {Vec3(0, -0.45, 0), Vec3(0, -1, 0)}}, Vec3(0.19, -0.6, -0.07), "leg"),
                    Vec3(1, 0, 0));
}

}  // namespace
}  // namespace halsted::scenes
