/// Faults by name and time, as the procedure itself brings them about.
#include "app/fault_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/banner.h"
#include "app/event_text.h"
#include "app/run_summary.h"

namespace halsted::app {
namespace {

using ::testing::HasSubstr;

constexpr double kDt = 0.5;                    // [s]

/// One step that is done with eight bites, within three seconds and without a tear.
Model oneStep() {
  Model m;
  ProcedureStep step;
  step.id = "bites";
  step.instruction = "Take eight bites.";
  step.done = {Quantity::kBites, 8.0};
  step.hasFault = true;
  step.fault = {Quantity::kTears, 1.0};
  step.faultName = "torn out";
  step.limit = 3.0;
  m.procedure = {step};
  return m;
}

/// Steps the procedure while what is seen stays the same.
void pass(const Model& m, double seconds, double tears, State& s, FaultLog& log) {   // [s]
  Observation seen{};
  seen[static_cast<int>(Quantity::kTears)] = tears;
  for (double t = 0.0; t < seconds; t += kDt) {
    ++s.step;
    const ProcedureEvent event = advance(m.procedure, seen, static_cast<double>(s.step) * kDt, kDt, s.procedure);
    StepOutput out;
    if (event != ProcedureEvent::kNone) out.events[out.eventCount++] = {s.step, event == ProcedureEvent::kLate ? EventKind::kStepLate : EventKind::kFault, -1, 0, 0.0};
    log.add(out, kDt);
  }
}

TEST(FaultLog, NamesEachFaultWhenItBegins) {
  const Model m = oneStep();
  State s;
  FaultLog log;
  pass(m, 1.0, 0.0, s, log);
  pass(m, 1.0, 1.0, s, log);                   // one occurrence, however long
  pass(m, 2.0, 0.0, s, log);
  pass(m, 0.5, 1.0, s, log);
  const auto lines = log.lines(m);
  ASSERT_EQ(lines.size(), 3u);
  ASSERT_EQ(s.procedure.faults[0], 3);
  EXPECT_EQ(lines[0].name, "torn out");
  EXPECT_EQ(lines[0].time, 1.5);
  EXPECT_EQ(lines[1].name, "took longer than 3 s");
  EXPECT_EQ(lines[1].time, 3.5);
  EXPECT_EQ(lines[2].name, "torn out");
  EXPECT_EQ(lines[2].time, 4.5);
}

TEST(FaultLog, TellsTwoThatBeginTogether) {
  const Model m = oneStep();
  State s;
  FaultLog log;
  pass(m, 3.0, 0.0, s, log);
  pass(m, 1.0, 1.0, s, log);
  const auto lines = log.lines(m);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].name, "torn out");
  EXPECT_EQ(lines[1].name, "took longer than 3 s");
  EXPECT_EQ(lines[1].time, lines[0].time + kDt);   // one event a step
}

TEST(FaultLog, IsShownUnderItsStepAndInTheObject) {
  RunSummary run;
  run.procedure = {{"bites", "Take eight bites.", true, 1.25, 1}, {"tighten", "Tighten.", false, 0.0, 0}};
  run.faults = {{0, "torn \"out\"", 1.5}};
  EXPECT_THAT(textOf(run), HasSubstr("bites  at 1.25 s  faults: 1\n          fault at 1.50 s: torn \"out\"\n  open  tighten"));
  EXPECT_THAT(jsonOf(run, ""), HasSubstr("\"step\": \"bites\",\n      \"name\": \"torn \\\"out\\\"\",\n      \"time_s\": 1.5"));
}

TEST(Banner, KeepsAFaultWhileLessHappens) {
  const Model m = oneStep();
  Banner banner;
  banner.tell({2000, EventKind::kFault, -1, 0, 0.0}, m, 10.0);
  banner.tell({2001, EventKind::kNeedleReleased, kRight, -1, 0.0}, m, 10.1);
  EXPECT_EQ(banner.at(10.2), number("%.1f s: fault: torn out", 2000 * m.params.dt));
  banner.tell({2002, EventKind::kStepLate, -1, 0, 0.0}, m, 10.3);
  EXPECT_THAT(banner.at(10.4), HasSubstr("took longer"));
  banner.tell({9000, EventKind::kNeedleReleased, kRight, -1, 0.0}, m, 15.0);
  EXPECT_THAT(banner.at(15.0), HasSubstr("needle released"));
  EXPECT_EQ(banner.at(20.0), "");
}

TEST(Banner, KeepsWhatHasTornToo) {
  const Model m = oneStep();
  Banner banner;
  banner.tell({2000, EventKind::kWallPerforated, kLeft, 1, 14.2}, m, 10.0);
  banner.tell({2001, EventKind::kNeedleReleased, kRight, -1, 0.0}, m, 10.1);
  EXPECT_THAT(banner.at(10.2), HasSubstr("wall perforated by the instrument, 14.2 N"));
  banner.tell({2002, EventKind::kChannelTorn, -1, 0, 6.5}, m, 10.3);
  EXPECT_THAT(banner.at(10.4), HasSubstr(name(EventKind::kChannelTorn)));
}

TEST(EventText, SaysWhichFaultAndWhy) {
  const Model m = oneStep();
  EXPECT_EQ(eventText({1, EventKind::kFault, -1, 0, 0.0}, m.procedure), "fault: torn out");
  EXPECT_EQ(eventText({1, EventKind::kStepLate, -1, 0, 0.0}, m.procedure), "fault: took longer than 3 s");
  EXPECT_EQ(eventText({1, EventKind::kThreadRefused, kRight, static_cast<int>(ThreadRefusal::kNoneLeft), 0.0}, m.procedure),
            std::string("no thread handed: ") + name(ThreadRefusal::kNoneLeft));
  EXPECT_EQ(eventText({1, EventKind::kClampRefused, kLeft, static_cast<int>(ClampRefusal::kHoldsNothing), 0.0}, m.procedure),
            std::string("clamp not taken over: ") + name(ClampRefusal::kHoldsNothing));
  EXPECT_EQ(eventText({1, EventKind::kStepDone, -1, 0, 0.0}, m.procedure), "step done");
}

}  // namespace
}  // namespace halsted::app
