#include "app/carriers/spsc_ring.h"

#include <gtest/gtest.h>

#include <thread>

namespace halsted::app {
namespace {

TEST(SpscRing, GivesValuesBackInOrder) {
  SpscRing<int> ring(4);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  int value = -1;
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(ring.pop(value));
    EXPECT_EQ(value, i);
  }
  EXPECT_FALSE(ring.pop(value));
}

TEST(SpscRing, CountsWhatDoesNotFitAndKeepsWhatDid) {
  SpscRing<int> ring(3);
  for (int i = 0; i < 10; ++i) ring.push(i);
  EXPECT_EQ(ring.dropped(), 7u);
  int value = -1;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(ring.pop(value));
    EXPECT_EQ(value, i);
  }
}

/// Received + dropped = pushed, in order, whatever the interleaving.
TEST(SpscRing, LosesNothingUncounted) {
  constexpr std::uint64_t kCount = 300'000;
  SpscRing<std::uint64_t> ring(64);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kCount; ++i) ring.push(i);
    done = true;
  });
  std::uint64_t received = 0, last = 0, disorder = 0, value = 0;
  for (bool finished = false; !finished;) {
    finished = done;
    while (ring.pop(value)) {
      disorder += value <= last;
      last = value;
      ++received;
    }
  }
  writer.join();
  EXPECT_EQ(disorder, 0u);
  EXPECT_EQ(received + ring.dropped(), kCount);
}

}  // namespace
}  // namespace halsted::app
