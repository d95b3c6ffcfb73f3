/// What a tick costs: a fixed number of uncontended locks and one sleep, no heap, no file; and the error it allows itself.
#include <optional>

#include "tests/hd/hd_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted::hdtest {
namespace {

using Tick = Hd;

TEST_F(Tick, MakesTheSameFewCallsEveryTimeAndNoneToTheHeap) {
  if (!test::RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdEnable(HD_FORCE_OUTPUT);
  hdStartScheduler();
  std::optional<test::RealtimeGuard> guard;
  std::uint64_t calls = 0;
  const int ticks = 1000;
  std::string first;
  inTicks(ticks + 1, [&](int tick) {
    if (tick == 0) guard.emplace();
    hdBeginFrame(device);
    double position[3], force[3] = {0, 0, 0};
    hdGetDoublev(HD_CURRENT_POSITION, position);
    force[1] = -0.05 * position[1];
    hdSetDoublev(HD_CURRENT_FORCE, force);
    hdEndFrame(device);
    if (tick < ticks) return;
    calls = guard->calls();
    first = guard->first();
    guard.reset();
  });
  // Locks: four calls of the program in this and in the last tick; between: order, begin and end of the callback, end of the tick.
  // Each lock counts once, the sleep once.
  const std::uint64_t most = (4 + 4 + 1) * static_cast<std::uint64_t>(ticks) + 4;
  EXPECT_GT(calls, 0u);
  EXPECT_LE(calls, most);
  EXPECT_EQ(first, "pthread_mutex_lock");
}

}  // namespace
}  // namespace halsted::hdtest
