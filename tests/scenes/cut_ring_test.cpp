/// What the scripted surgeon sees of the line along which a prolapse is cut.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/cut_ring.h"
#include "scenes/expert.h"
#include "scenes/prolapse.h"
#include "sim/portable_math.h"
#include "sim/step.h"
#include "tests/scenes/prolapse_params.h"
#include "tests/scenes/wall_laws.h"

namespace halsted::scenes {
namespace {

class CutRings : public ::testing::Test {
 protected:
  const Model model = buildModel(penAndProlapse(), prolapse(prolapsed()), {});
  State state = initialState(model, startPoses(model));
  const AnatomyParams& anatomy = model.params.anatomy;
};

/// Of the outer wall on its mucosa, of the inner on its serosa: where a pen comes to it from outside.
TEST_F(CutRings, LieOnTheSideThatThePenComesToAndFaceIt) {
  for (const int wall : {0, 1}) {
    const CutRing ring = ringOn(model, wall, 0.0);
    ASSERT_EQ(ring.column.size(), static_cast<std::size_t>(anatomy.around));
    const double radius = wall == 0 ? anatomy.radius : anatomy.radius - anatomy.wall - anatomy.gap;   // [m]
    for (double column = 0.0; column < anatomy.around; column += 0.5) {
      const RingPlace place = placeOnRing(ring, state, column);
      const double angle = 2.0 * kPi * column / anatomy.around;            // [rad]
      EXPECT_NEAR(place.point.z(), anatomy.cutHeight - 0.4 * anatomy.length, 1e-12);
      EXPECT_NEAR(place.point.head<2>().norm(), radius, 0.005 * radius);   // half way along a chord it is a little nearer
      EXPECT_GT(place.out.dot(Vec3(cosine(angle), sine(angle), 0.0)), 0.999);
    }
    EXPECT_LT(centreOf(ring, state).head<2>().norm(), 1e-12);
  }
}

TEST_F(CutRings, FollowTheHeightThatIsAskedFor) {
  const RingPlace place = placeOnRing(ringOn(model, 0, -2e-3), state, 7.0);
  EXPECT_NEAR(place.point.z(), anatomy.cutHeight + 2e-3 - 0.4 * anatomy.length, 1e-12);
  EXPECT_FALSE(ringOn(model, 0, -0.2).present());
}

TEST_F(CutRings, FindBridgesUntilAllOfTheirRowHasGone) {
  const CutRing ring = ringOn(model, 1, 0.0);
  Bridge bridge;
  for (const int column : {0, 17, 35}) {
    ASSERT_EQ(ring.cell[static_cast<std::size_t>(column)].size(), 6u);
    for (int t : ring.cell[static_cast<std::size_t>(column)]) {
      EXPECT_NEAR(model.mesh.cutLine[static_cast<std::size_t>(t)].fromLine, 0.0, 1e-12);
      ASSERT_TRUE(bridgeAt(ring, model, state, column, bridge));
      EXPECT_NEAR(bridge.middle.z(), anatomy.cutHeight - 0.4 * anatomy.length, 1e-12) << "as far from one edge as from the other";
      state.tissue.gone[static_cast<std::size_t>(t)] = 1;
    }
    EXPECT_FALSE(bridgeAt(ring, model, state, column, bridge));
  }
}

TEST(ExcisionScript, IsReadAndRefusedInWords) {
  const auto parse = [](const std::string& action) { return parseExpert("scene = \"altemeier\"\n[[action]]\n" + action, "test"); };
  const ExpertAction cut = parse("do = \"cut_ring\"\nwall = \"inner\"\nheight_mm = 13\nfrom_deg = 90\nspeed_mm_s = 6\n").actions.at(0);
  EXPECT_EQ(cut.bowel, 1);
  EXPECT_DOUBLE_EQ(cut.height, 13e-3);
  EXPECT_DOUBLE_EQ(cut.angleDegrees, 90.0);
  EXPECT_DOUBLE_EQ(cut.speed, 6e-3);
  testing::expectRefused([&] { parse("do = \"cut_ring\"\nwall = \"middle\"\n"); }, {"action.wall", "outer"});
  testing::expectRefused([&] { parse("do = \"cut_ring\"\nheight_mm = 0.1\n"); }, {"action.height_mm", "1 to 100"});
}

}  // namespace
}  // namespace halsted::scenes
