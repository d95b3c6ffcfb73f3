/// The shipped tick calls nothing that could make it wait (DESIGN 8), and the guard that says so can see such calls.
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "tests/haptics/bench_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted::haptics {
namespace {

using test::RealtimeGuard;

class RealtimeTick : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  }
};

TEST_F(RealtimeTick, GuardSeesTheHeap) {
  RealtimeGuard guard;
  auto block = std::make_unique<int[]>(100);
  ASSERT_NE(block.get(), nullptr);
  EXPECT_GE(guard.calls(), 1u);
  EXPECT_STREQ(guard.first(), "malloc");
}

TEST_F(RealtimeTick, GuardSeesALock) {
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  RealtimeGuard guard;
  pthread_mutex_lock(&mutex);
  pthread_mutex_unlock(&mutex);
  EXPECT_EQ(guard.calls(), 1u);
  EXPECT_STREQ(guard.first(), "pthread_mutex_lock");
}

TEST_F(RealtimeTick, GuardSeesSleepAndWrite) {
  RealtimeGuard guard;
  usleep(1);
  const ssize_t written = write(STDERR_FILENO, "", 0);
  EXPECT_EQ(written, 0);
  EXPECT_EQ(guard.calls(), 2u);
  EXPECT_STREQ(guard.first(), "usleep");
}

TEST_F(RealtimeTick, GuardCountsOnlyItsOwnLife) {
  std::free(std::malloc(10));
  RealtimeGuard guard;
  EXPECT_EQ(guard.calls(), 0u);
  EXPECT_STREQ(guard.first(), "none");
}

/// Ten thousand ticks with contact, loss of contact, a stall, a broken model and a lost device in them.
TEST_F(RealtimeTick, ShippedTickNeverCallsHeapLockSleepOrFile) {
  SpringWall wall{800.0, 1.0};
  Rig rig;
  rig.target.pose.position.y() = -4e-3;
  RealtimeGuard guard;
  for (int i = 0; i < 10000; ++i) {
    if (i % 1000 == 500) rig.target.pose.position.y() = -rig.target.pose.position.y();
    if (i % 2000 == 1200) rig.contact.force.x() = std::nan(""), rig.contact.step = ++rig.steps;
    rig.device.setConnected(i % 3000 < 2900);
    const bool stalled = i % 4000 > 3800;
    stalled ? rig.tickOnly() : rig.advance(wall);
  }
  EXPECT_EQ(guard.calls(), 0u) << guard.first();
}

}  // namespace
}  // namespace halsted::haptics
