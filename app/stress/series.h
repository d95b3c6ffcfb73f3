#pragma once
/// Paper 003, section 3.5: what a physics step costs as stitch follows stitch, to fifty. One thread, no script: the stitches are laid, not
/// sewn, and then everything is physics. What is timed is `step`, with needle, thread, tools and all contacts of the scene, hands at rest.
#include <string>
#include <vector>

#include "app/progress.h"
#include "app/scenario.h"

namespace halsted::app {

struct StressPoint {
  int stitches = 0;
  double stepMedian = 0.0, step99 = 0.0;       // [ms]
  double iterations = 0.0;                     // [1] of the thread's solve, mean of a step
  double threadSpeed = 0.0;                    // [m/s] largest, mean of the steps: a thread at rest has none
  double tension = 0.0;                        // [N] largest in a stitch or in the thread
  double gap = 0.0;                            // [m] between the two edges at the stitches, at most; one body: 0
  int torn = 0;
};

struct StressSeries {
  std::string name;                            // "two-bodies" or "one-body"
  std::string what;                            // one line for the reader
  double dt = 0.0;                             // [s] of a step
  int particles = 0, tets = 0, threadNodes = 0;
  std::vector<StressPoint> points;             // ascending stitches, the first without any
};

inline constexpr int kMostStressed = 50;       // stitches, as in the paper's figures 22 and 23
inline constexpr int kTimedSteps = 400;

/// Two bowel ends joined rim to rim by tied, full-thickness stitches all the way round, each drawn until the edges meet.
StressSeries stressTwoBodies(Progress&);
/// One open end with one running thread of 56 cm, in and out of the wall along a spiral behind its rim.
StressSeries stressOneBody(Progress&);

/// Its scene, and one of its points: the thread laid with `bites` bites (0 to kMostStressed), left to settle, then timed.
Scenario oneBodyScenario();
StressPoint oneBodyWith(const Scenario&, int bites);

/// Frame of 12 ms against stitches, with the paper's two published points. Throws scenes::InputError when the file cannot be written.
void writePlot(const StressSeries&, const std::string& file);

}  // namespace halsted::app
