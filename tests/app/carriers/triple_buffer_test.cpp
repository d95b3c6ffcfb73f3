#include "app/carriers/triple_buffer.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

namespace halsted::app {
namespace {

TEST(TripleBuffer, HasNothingNewBeforeTheFirstPublish) {
  TripleBuffer<int> buffer(7);
  EXPECT_FALSE(buffer.acquire());
  EXPECT_EQ(buffer.front(), 7);
}

TEST(TripleBuffer, GivesTheNewestValueOnce) {
  TripleBuffer<int> buffer;
  for (int value : {1, 2, 3}) {
    buffer.back() = value;
    buffer.publish();
  }
  EXPECT_TRUE(buffer.acquire());
  EXPECT_EQ(buffer.front(), 3);
  EXPECT_FALSE(buffer.acquire());
  EXPECT_EQ(buffer.front(), 3);
}

TEST(TripleBuffer, KeepsTheSizeOfVectorsInEverySlot) {
  TripleBuffer<std::vector<double>> buffer(std::vector<double>(100, 0.0));
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(buffer.back().size(), 100u);
    buffer.publish();
    buffer.acquire();
    ASSERT_EQ(buffer.front().size(), 100u);
  }
}

/// A value is never torn and never goes back in time, whatever the interleaving.
TEST(TripleBuffer, IsNeverTornAndNeverGoesBack) {
  constexpr std::uint64_t kCount = 200'000;
  using Value = std::array<std::uint64_t, 16>;
  TripleBuffer<Value> buffer(Value{});
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kCount; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  });
  std::uint64_t last = 0, torn = 0, backward = 0;
  while (last < kCount) {
    if (!buffer.acquire()) continue;
    const Value& value = buffer.front();
    for (std::uint64_t entry : value) torn += entry != value[0];
    backward += value[0] <= last;
    last = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backward, 0u);
  EXPECT_EQ(last, kCount);
}

}  // namespace
}  // namespace halsted::app
