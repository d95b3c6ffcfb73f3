#pragma once
/// What the work is worth once it is done: the seam is put under pressure until it leaks, and the lumen is measured. Outside the step and
/// after the last one: plain functions of a model and a copy of the state.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kPascalPerMmhg = 133.322;                // [Pa/mmHg]

struct LeakTest {
  double rate = 1.0;                           // [mmHg/s] physics.md C6
  double most = 80.0;                          // [mmHg] above all published hand-sewn seams (4 to 76)
  double gap = 0.2e-3;                         // [m] between the walls: wider leaks (C6, design)
  double settle = 0.5;                         // [s] before the pressure rises
};

enum class LeakEnd { kHeld, kGap, kTear, kOpen };                // kOpen: leaked before any pressure

struct Outcome {
  bool tested = false;                         // there are two ends and thread that joins them
  LeakEnd end = LeakEnd::kOpen;
  double leakPressure = 0.0;                   // [mmHg] at which the sewn stretch leaked; `most` when it held
  double rimGap = 0.0, wallGap = 0.0;          // [m] along the sewn stretch before the test
  double sewnShare = 0.0;                      // [1] of the circumference between the first and the last stitch
  double narrowing = 0.0;                      // [1] of the lumen at the seam: 0 as at rest, 1 closed
};

/// The hands stay where they are, holding what they hold. The pressure acts on the lumen's wall; only the sewn stretch is judged, the rest
/// of the circumference counts as closed. A prolapse that is cut off is tested as it stands, turned out: its outer wall's mucosa lines the
/// lumen, too, once it is back in place, so the pressure acts on both mucosae and leaks between the two serosae.
Outcome testOutcome(const Model&, State, const LeakTest& = {});

/// Adds the load of a pressure on the lumen's wall to the tissue's nodal forces.  [N]
void gatherPressure(const Model&, const State&, double pressure, std::vector<Vec3>& nodal);   // [Pa]

std::vector<std::pair<std::string, double>> summarise(const Outcome&);

}  // namespace halsted
