/// What `halsted bench --stress` lays: stitches where they should be, at rest, and a curve that says what was measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/scenario.h"
#include "app/stress/series.h"
#include "app/stress/wall_points.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

TEST(WallPoints, LieOnTheirSideOfTheWallAtTheirDepth) {
  const Scenario scenario = scenarioFromScene("connell", {}, {});
  const Model& m = scenario.model;
  for (int bowel = 0; bowel < 2; ++bowel)
    for (double turn = 0.0; turn < 1.0; turn += 0.07) {
      const TissuePoint outer = wallPoint(m, bowel, WallSide::kSerosa, turn, 4e-3), inner = wallPoint(m, bowel, WallSide::kMucosa, turn, 4e-3);
      const Vec3 a = pointOf(m, outer, m.mesh.vertices), b = pointOf(m, inner, m.mesh.vertices);
      EXPECT_NEAR((a - b).norm(), m.params.anatomy.wall, 0.3 * m.params.anatomy.wall) << bowel << " " << turn;
      const Opening& opening = m.bowels.opening[bowel];
      EXPECT_NEAR(opening.axis.dot(opening.centre - a), 4e-3, 1.5e-3) << bowel << " " << turn;
    }
  EXPECT_THROW(wallPoint(m, 0, WallSide::kSerosa, 0.3, 1.0), std::out_of_range);
}

/// The same place of both ends: rims face each other there.
TEST(WallPoints, AreMirroredAtTheOtherEnd) {
  const Scenario scenario = scenarioFromScene("connell", {"anatomy.gap=1e-3"}, {});
  const Model& m = scenario.model;
  for (double turn = 0.0; turn < 1.0; turn += 0.11) {
    const Vec3 left = pointOf(m, wallPoint(m, 0, WallSide::kSerosa, turn, 0.0), m.mesh.vertices);
    const Vec3 right = pointOf(m, wallPoint(m, 1, WallSide::kSerosa, 0.5 - turn, 0.0), m.mesh.vertices);
    EXPECT_NEAR((left - right).norm(), 1e-3, 0.6e-3) << turn;
  }
}

/// Over the rod, through two holes or through a hundred: what is drawn lies still, and is solved at once.
TEST(OneBody, ARunningThreadComesToRest) {
  const Scenario scenario = oneBodyScenario();
  for (const int bites : {5, 10, 15, 25, 40, 49, 50}) {
    const StressPoint p = oneBodyWith(scenario, bites);
    EXPECT_LT(p.threadSpeed, 0.02) << bites << " bites";         // [m/s]
    EXPECT_LT(p.iterations, 1.5) << bites << " bites";
    EXPECT_EQ(p.torn, 0) << bites << " bites";
  }
}

TEST(StressPlot, ShowsEveryPointAndRefusesAFileItCannotWrite) {
  const testing::TemporaryFolder folder;
  StressSeries series{"two-bodies", "two ends", 1e-3, 1, 1, 1, {}};
  for (int n = 0; n <= kMostStressed; ++n) series.points.push_back({n, 0.5, 0.7, 0.1, 0.0, 0});
  writePlot(series, folder.file("curve.svg"));
  std::stringstream text;
  text << std::ifstream(folder.file("curve.svg")).rdbuf();
  const std::string svg = text.str(), curve = svg.substr(svg.find("points='") + 8);
  EXPECT_EQ(std::count(curve.begin(), curve.begin() + static_cast<long>(curve.find('\'')), ','), kMostStressed + 1);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_THROW(writePlot(series, folder.file("none/curve.svg")), scenes::InputError);
}

}  // namespace
}  // namespace halsted::app
