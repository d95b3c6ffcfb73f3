/// Changes of force that are too small to be answered within their step.
#include <gtest/gtest.h>

#include "tests/sim/press_rig.h"

namespace halsted {
namespace {

/// So slowly that no step's change of force is worth an answer within it (step.cpp): the next step's forces hold it all the same.
TEST(SlowPress, IsHeldAsAFastOneIs) {
  constexpr double kFrom = -0.2e-3, kBy = -0.1e-3;   // [m]
  constexpr int kSteps = 4000;
  Press slow, fast;
  for (Press* p : {&slow, &fast}) {
    for (int k = 0; k <= 300; ++k) p->to(pressing(kFrom + 5e-3 * (1.0 - k / 300.0)));
    p->run(1000);
  }
  const Vec3 before = slow.onTissue();
  double most = 0.0;                             // [N] change in a step
  for (int k = 1; k <= kSteps; ++k) {
    const Vec3 last = slow.onTissue();
    slow.to(pressing(kFrom + kBy * k / kSteps));
    if (k > 10) most = std::max(most, (slow.onTissue() - last).norm());
  }
  const Vec3 held = slow.footReaction(), atOnce = slow.onTissue();
  for (int k = 0; k < 1000; ++k) fast.to(pressing(kFrom + kBy));
  std::printf("pressed slowly: %.4f N, at most %.2g N more in a step; held by %.4f N; pressed at once and left: %.4f N\n", atOnce.norm(), most, held.norm(), fast.onTissue().norm());
  ASSERT_LT(most, 1e-4);
  ASSERT_GT((atOnce - before).norm(), 200.0 * most);
  EXPECT_LT((held - atOnce).norm(), 0.01 * atOnce.norm());
  EXPECT_LT((fast.onTissue() - atOnce).norm(), 0.01 * atOnce.norm());
}

}  // namespace
}  // namespace halsted
