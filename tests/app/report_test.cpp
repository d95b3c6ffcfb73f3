#include "app/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace halsted::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RunSummary exampleRun() {
  RunSummary run;
  run.scene = "purse_string";
  run.title = "Purse <string> & \"more\"";
  run.dt = 1e-3;
  run.steps = 2000;
  run.procedure = {{"bites", "Take eight bites.", true, 1.25, 0}, {"tighten", "Tighten.", false, 0.0, 2}};
  run.metrics = {{"path_length_left_m", 0.123}};
  return run;
}

Trace exampleTrace() {
  Trace trace(1e-3);
  State state;
  const Event bite{1500, EventKind::kBiteCompleted, kRight, 0, 0.006};
  for (state.step = 1; state.step <= 2000; ++state.step) {
    state.tools[kLeft].force = Vec3(0, 0, state.step == 777 ? 2.5 : 0.1);
    trace.add(state, &bite, state.step == 1500 ? 1 : 0);
  }
  return trace;
}

TEST(Report, ShowsProcedureMetricsForcesAndEvents) {
  const std::string html = reportHtml(exampleRun(), exampleTrace());
  for (const char* expected : {"Take eight bites.", "1.25 s", "path_length_left_m", "0.123", "<svg", "2.50 N", "bite completed", "1.500 s", "2.0 s"})
    EXPECT_THAT(html, HasSubstr(expected));
}

TEST(Report, GivesEachEventItsUnit) {
  Trace trace(1e-3);
  const Event events[] = {{1, EventKind::kBiteCompleted, kRight, 0, 0.0061}, {2, EventKind::kChannelTorn, -1, 0, 7.25}, {3, EventKind::kTissueCut, kRight, 4, 0.125},
                          {4, EventKind::kPieceFree, -1, 1, 3e-6}, {5, EventKind::kStepDone, -1, 1, 0.0}, {6, EventKind::kNeedleEntered, -1, 7, 0.0}};
  trace.add(State{}, events, 6);
  const std::string html = reportHtml(exampleRun(), trace);
  for (const char* expected : {"0.0061 m<", "7.25 N<", "0.125 J<", "3e-06 m^3<"}) EXPECT_THAT(html, HasSubstr(expected));
  EXPECT_THAT(html, HasSubstr("step done</td><td></td><td class=n>1</td><td class=n></td>"));   // no value: none is shown
  EXPECT_THAT(html, HasSubstr("needle entered</td><td></td><td class=n>7</td><td class=n></td>"));   // of a suture: its force is not told
}

TEST(Report, IsSelfContainedAndEscaped) {
  const std::string html = reportHtml(exampleRun(), exampleTrace());
  EXPECT_THAT(html, HasSubstr("Purse &lt;string&gt; &amp; &quot;more&quot;"));
  for (const char* outside : {"http://", "https://", "<script", "src=", "href="}) EXPECT_THAT(html, Not(HasSubstr(outside)));
}

/// A force of one millisecond is not lost between two samples of ten.
TEST(Trace, KeepsShortPeaks) {
  const Trace trace = exampleTrace();
  ASSERT_EQ(trace.samples().size(), 200u);
  double peak = 0.0;
  for (const Trace::Sample& sample : trace.samples()) peak = std::max(peak, sample.force[kLeft]);
  EXPECT_DOUBLE_EQ(peak, 2.5);
}

}  // namespace
}  // namespace halsted::app
