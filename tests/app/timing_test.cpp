#include "app/timing.h"

#include <gtest/gtest.h>

namespace halsted::app {
namespace {

TEST(Durations, PercentilesAreThoseOfTheSortedSamples) {
  Durations durations;
  for (int i = 1000; i >= 1; --i) durations.add(i * 1e-6);
  const Percentiles us = durations.percentiles(1e6);
  EXPECT_NEAR(us.p50, 500.0, 1.0);
  EXPECT_NEAR(us.p99, 990.0, 1.0);
  EXPECT_NEAR(us.max, 1000.0, 1e-9);
  EXPECT_NEAR(durations.total(), 500500e-6, 1e-9);
}

TEST(Durations, NothingMeasuredIsZero) { EXPECT_EQ(Durations().percentiles(1e3).p99, 0.0); }

TEST(Durations, OutliersKeepTheirExactMaximum) {
  Durations durations(1e-6, 100);
  for (int i = 0; i < 10; ++i) durations.add(5.0);
  EXPECT_EQ(durations.percentiles(1.0).max, 5.0);
  EXPECT_EQ(durations.percentiles(1.0).p50, 5.0);
  durations.add(-1.0);
  EXPECT_EQ(durations.count(), 11u);
}

}  // namespace
}  // namespace halsted::app
