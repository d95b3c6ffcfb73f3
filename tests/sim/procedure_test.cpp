/// Laws of the procedure table.
#include "sim/procedure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/sim/rehearsal.h"

namespace halsted {
namespace {

ProcedureStep bites(double min, double hold = 0.0) {     // [1], [s]
  ProcedureStep step;
  step.id = "bites";
  step.done = {Quantity::kBites, min, 1e300, hold};
  return step;
}

ProcedureStep bitesWithFault() {
  ProcedureStep step = bites(8);
  step.hasFault = true;
  step.fault = {Quantity::kPeakForce, 2.0, 1e300, 0.0};
  return step;
}

TEST(Procedure, NamesAndQuantitiesAreOneToOne) {
  for (int i = 0; i < kQuantities; ++i) {
    Quantity parsed = Quantity::kCount;
    ASSERT_TRUE(parseQuantity(name(static_cast<Quantity>(i)), parsed));
    EXPECT_EQ(static_cast<int>(parsed), i);
  }
  Quantity parsed = Quantity::kTime;
  EXPECT_FALSE(parseQuantity("no_such_quantity", parsed));
  EXPECT_STREQ(name(Quantity::kTears), "tears");
  EXPECT_STREQ(name(Quantity::kRimToAnvil), "rim_to_anvil");
  EXPECT_STREQ(name(Quantity::kPeakTension), "peak_tension");
}

TEST(Procedure, StepsAreDoneInOrderAndTheLastCompletes) {
  Rehearsal run{{bites(1), bites(2)}};
  EXPECT_EQ(run.once(), ProcedureEvent::kNone);
  run[Quantity::kBites] = 2;
  EXPECT_EQ(run.once(), ProcedureEvent::kStepDone);
  EXPECT_EQ(run.once(), ProcedureEvent::kCompleted);
  EXPECT_EQ(run.once(), ProcedureEvent::kNone);
  EXPECT_EQ(run.state.current, 2);
  EXPECT_DOUBLE_EQ(run.state.finished[0], 2 * kDt);
  EXPECT_DOUBLE_EQ(run.state.finished[1], 3 * kDt);
}

TEST(Procedure, AConditionMustHoldWithoutAGap) {
  Rehearsal run{{bites(1, 0.1)}};
  run[Quantity::kBites] = 1;
  EXPECT_EQ(run.countEvents(99, ProcedureEvent::kNone), 99);
  run[Quantity::kBites] = 0;
  run.once();
  run[Quantity::kBites] = 1;
  EXPECT_EQ(run.countEvents(99, ProcedureEvent::kNone), 99);
  EXPECT_EQ(run.once(), ProcedureEvent::kCompleted);
}

TEST(Procedure, AFaultCountsOncePerOccurrence) {
  Rehearsal run{{bitesWithFault()}};
  run[Quantity::kPeakForce] = 3.0;
  EXPECT_EQ(run.countEvents(500, ProcedureEvent::kFault), 1);
  run[Quantity::kPeakForce] = 0.0;
  EXPECT_EQ(run.countEvents(500, ProcedureEvent::kFault), 0);
  run[Quantity::kPeakForce] = 3.0;
  EXPECT_EQ(run.countEvents(500, ProcedureEvent::kFault), 1);
  EXPECT_EQ(run.state.faults[0], 2);
}

TEST(Procedure, AFaultThatGoesOnUnderTheSameConditionIsNotCountedAgain) {
  Rehearsal run{{bitesWithFault(), bitesWithFault(), bites(9)}};
  run.table[1].done.min = 9;
  run[Quantity::kPeakForce] = 3.0;
  run.once();
  run[Quantity::kBites] = 8;
  EXPECT_EQ(run.once(), ProcedureEvent::kStepDone);
  EXPECT_EQ(run.countEvents(100, ProcedureEvent::kFault), 0);
  EXPECT_EQ(run.state.faults[0] + run.state.faults[1], 1);
}

TEST(Procedure, ABriefFaultUnderItsHoldTimeIsForgiven) {
  Rehearsal run{{bitesWithFault()}};
  run.table[0].fault.hold = 0.05;
  run[Quantity::kPeakForce] = 3.0;
  EXPECT_EQ(run.countEvents(49, ProcedureEvent::kFault), 0);
  run[Quantity::kPeakForce] = 0.0;
  run.once();
  EXPECT_EQ(run.state.faults[0], 0);
  run[Quantity::kPeakForce] = 3.0;
  EXPECT_EQ(run.countEvents(50, ProcedureEvent::kFault), 1);
}

TEST(Procedure, ExceedingTheLimitIsOneFault) {
  Rehearsal run{{bites(1)}};
  run.table[0].limit = 0.2;
  EXPECT_EQ(run.countEvents(199, ProcedureEvent::kLate), 0);
  EXPECT_EQ(run.countEvents(1000, ProcedureEvent::kLate), 1);
  EXPECT_EQ(run.state.faults[0], 1);
}

TEST(Procedure, TheLimitIsCountedFromTheStartOfItsStep) {
  Rehearsal run{{bites(1), bites(2)}};
  run.table[1].limit = 0.2;
  run.countEvents(500, ProcedureEvent::kNone);
  run[Quantity::kBites] = 1;
  EXPECT_EQ(run.once(), ProcedureEvent::kStepDone);
  EXPECT_EQ(run.countEvents(199, ProcedureEvent::kLate), 0);
  EXPECT_EQ(run.countEvents(10, ProcedureEvent::kLate), 1);
}

TEST(Procedure, AFaultAndItsStepsTimeAreTwoEvents) {
  Rehearsal run{{bitesWithFault()}};
  run.table[0].limit = 0.2;
  run.countEvents(200, ProcedureEvent::kNone);
  run[Quantity::kPeakForce] = 3.0;
  EXPECT_EQ(run.once(), ProcedureEvent::kFault);
  EXPECT_EQ(run.once(), ProcedureEvent::kLate);
  EXPECT_EQ(run.state.faults[0], 2);
}

TEST(Procedure, NoEventIsLostWhenDoneAndFaultCoincide) {
  Rehearsal run{{bitesWithFault()}};
  run[Quantity::kPeakForce] = 3.0;
  run[Quantity::kBites] = 8;
  EXPECT_EQ(run.once(), ProcedureEvent::kFault);
  EXPECT_EQ(run.once(), ProcedureEvent::kCompleted);
}

TEST(Procedure, AQuantityThatIsNotANumberHoldsNothing) {
  Rehearsal run{{bites(-1e300)}};
  run[Quantity::kBites] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(run.once(), ProcedureEvent::kNone);
}

TEST(Procedure, AnEmptyTableDoesNothing) {
  Rehearsal run{{}};
  EXPECT_EQ(run.once(), ProcedureEvent::kNone);
}

ProcedureStep named(const char* id, Quantity q) {
  ProcedureStep step;
  step.id = id;
  step.done = {q, 1.0, 1e300, 0.0};
  return step;
}

/// take, sew, [take, sew ...] until there are three.
TEST(Procedure, AGroupIsDoneAgainUntilThereAreEnough) {
  ProcedureStep last = named("sew", Quantity::kBites);
  last.repeatFrom = 1;
  last.enough = {Quantity::kStitches, 3.0, 1e300, 0.0};
  Rehearsal run{{named("look", Quantity::kTears), named("take", Quantity::kNeedleHeld), last, named("end", Quantity::kThrows)}};
  run[Quantity::kTears] = run[Quantity::kNeedleHeld] = run[Quantity::kBites] = 1;
  EXPECT_EQ(run.countEvents(3, ProcedureEvent::kStepDone), 3);
  EXPECT_EQ(run.state.current, 1);
  EXPECT_EQ(run.countEvents(2, ProcedureEvent::kStepDone), 2);
  EXPECT_EQ(run.state.current, 1);
  EXPECT_DOUBLE_EQ(run.state.finished[2], 5 * kDt);              // the last time
  run[Quantity::kStitches] = 3;
  EXPECT_EQ(run.countEvents(2, ProcedureEvent::kStepDone), 2);
  EXPECT_EQ(run.state.current, 3);
  run[Quantity::kThrows] = 1;
  EXPECT_EQ(run.once(), ProcedureEvent::kCompleted);
}

/// take, bite, tie: the thread is taken out again while it is being tied.
TEST(Procedure, WhatIsUndoneIsBegunAnewWithItsTimeLimits) {
  ProcedureStep tie = named("tie", Quantity::kKnotLocks);
  tie.limit = 5.5 * kDt;
  tie.againFrom = 1;
  tie.undone = {Quantity::kBites, -1e300, 0.0, 0.0};
  Rehearsal run{{named("look", Quantity::kTears), named("bite", Quantity::kBites), tie}};
  run[Quantity::kTears] = run[Quantity::kBites] = 1;
  EXPECT_EQ(run.countEvents(6, ProcedureEvent::kStepDone), 2);   // four steps of five on the way
  run[Quantity::kBites] = 0;
  EXPECT_EQ(run.once(), ProcedureEvent::kBegunAnew);
  EXPECT_EQ(run.state.current, 1);
  run[Quantity::kBites] = 1;
  EXPECT_EQ(run.once(), ProcedureEvent::kStepDone);
  EXPECT_EQ(run.countEvents(4, ProcedureEvent::kFault), 0);
  run[Quantity::kKnotLocks] = 1;
  EXPECT_EQ(run.once(), ProcedureEvent::kCompleted);
}

}  // namespace
}  // namespace halsted
