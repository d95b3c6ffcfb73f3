/// Laws of the metrics' summary.
#include "sim/metrics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace halsted {
namespace {

std::map<std::string, double> table(const MetricsState& m, double time = 0.0) {   // time [s]
  const auto rows = summarise(m, time);
  return {rows.begin(), rows.end()};
}

/// Of every kind of scene: with all that one with thread may have, and of one that is needled.
std::array<MetricsState, 2> everyKind() {
  std::array<MetricsState, 2> kinds;
  kinds[0].seam.emplace();
  kinds[0].assistedKnots = 0;
  kinds[0].cut.emplace();
  kinds[0].biteCount = kMaxBites;
  kinds[1].needling.emplace();
  return kinds;
}

TEST(Metrics, EveryNameIsUniqueAndEveryValueFiniteFromTheFirstStep) {
  for (const MetricsState& kind : everyKind()) {
    std::set<std::string> names;
    for (const auto& [name, value] : summarise(kind, 0.0)) {
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_TRUE(std::isfinite(value)) << name;
    }
  }
}

TEST(Metrics, QuantitiesWithAUnitEndInIt) {
  const std::set<std::string> counts = {"bites", "stitches_across_opening", "tears", "perforations", "full_thickness_bites", "crossings", "burnt_tets", "free_pieces",
                                        "pieces_taken", "crumbs", "assisted_knots", "twirl_strokes", "twirl_strokes_in_range", "lift_strokes", "lift_strokes_in_range"};
  const std::set<std::string> units = {"s", "m", "m2", "n", "pa", "deg", "1", "j", "nm"};
  for (const MetricsState& kind : everyKind())
    for (const auto& [name, value] : summarise(kind, 0.0))
      EXPECT_TRUE(counts.contains(name) || units.contains(name.substr(name.rfind('_') + 1))) << name;
}

TEST(Metrics, MeanForceIsOverLoadedStepsOnly) {
  MetricsState m;
  m.hands[kRight].forceSum = 6.0;
  m.hands[kRight].forceSteps = 4.0;
  EXPECT_DOUBLE_EQ(table(m)["mean_force_right_n"], 1.5);
  EXPECT_DOUBLE_EQ(table(m)["mean_force_left_n"], 0.0);
}

TEST(Metrics, SpreadIsTheSampleStandardDeviation) {
  MetricsState m;
  m.biteCount = 4;
  const double depth[4] = {2e-3, 4e-3, 4e-3, 6e-3};      // [m] mean 4, sum of squares 8 mm^2, n - 1 = 3
  for (int i = 0; i < 4; ++i) m.bites[i].depth = depth[i];
  auto t = table(m);
  EXPECT_NEAR(t["bite_depth_mean_m"], 4e-3, 1e-15);
  EXPECT_NEAR(t["bite_depth_sd_m"], std::sqrt(8.0 / 3.0) * 1e-3, 1e-15);
}

TEST(Metrics, TheFirstBiteHasNoSpacing) {
  MetricsState m;
  m.biteCount = 3;
  m.bites[0].spacing = 1.0;
  m.bites[1].spacing = 5e-3;
  m.bites[2].spacing = 7e-3;
  EXPECT_NEAR(table(m)["bite_spacing_mean_m"], 6e-3, 1e-15);
}

TEST(Metrics, EntryAngleIsGivenInDegrees) {
  MetricsState m;
  m.biteCount = 2;
  m.bites[0].entryAngle = 0.5;
  m.bites[1].entryAngle = 0.0;
  EXPECT_NEAR(table(m)["entry_angle_mean_deg"], 75.0, 1e-12);
}

TEST(Metrics, MoreBitesThanSlotsAreCountedButNotRead) {
  MetricsState m;
  m.biteCount = kMaxBites + 5;
  for (BiteMetrics& b : m.bites) b.depth = 3e-3;
  EXPECT_DOUBLE_EQ(table(m)["bites"], kMaxBites + 5);
  EXPECT_NEAR(table(m)["bite_depth_mean_m"], 3e-3, 1e-15);
}

TEST(Metrics, OpeningFractionIsRelativeToTheRestArea) {
  MetricsState m;
  m.restOpeningArea = 8e-4;
  m.openingArea = 2e-4;
  EXPECT_DOUBLE_EQ(table(m)["opening_fraction_1"], 0.25);
}

}  // namespace
}  // namespace halsted
