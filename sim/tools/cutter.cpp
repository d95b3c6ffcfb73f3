#include "sim/tools/cutter.h"

#include "sim/lanes.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/tools/instrument.h"

namespace halsted {
namespace {

constexpr double kBladeFrom = 8.0e-3, kBladeTo = 11.5e-3;        // [m] from the tips: behind what grips
constexpr double kBladeWidth = 1.0e-3;         // [m] across, to either side: a loop round the outside of the jaws is not between them
constexpr double kBladeOpen = 2.5e-3;          // [m] from the middle to either jaw near the hinge

bool betweenBlades(const Vec3& p) {            // [m] in the tool frame
  return p.z() > kBladeFrom && p.z() < kBladeTo && magnitude(p.y()) < kBladeWidth && magnitude(p.x()) < kBladeOpen;
}

}  // namespace

bool cutThread(const Model& m, int hand, State& s, StepOutput& out) {
  if (!toolOf(m, s, hand).cutter || s.threadContacts.cut.empty()) return false;
  constexpr int kSamples = 4;                  // per segment
  for (int i = 0; i + 1 < m.strand.nodes; ++i) {
    if (s.threadContacts.cut[i]) continue;
    for (int k = 0; k < kSamples; ++k) {
      const double share = (k + 0.5) / kSamples;                 // [1]
      const Vec3 p = (1.0 - share) * s.strand.position[i] + share * s.strand.position[i + 1];
      if (!betweenBlades(s.tools[hand].proxy.inverseApply(p))) continue;
      s.threadContacts.cut[i] = 1;
      s.strand.tension[i] = 0.0;
      ++s.knot.cuts;
      pushEvent(out, {s.step, EventKind::kThreadCut, hand, i, 0.0});
      return true;
    }
  }
  return false;
}

}  // namespace halsted
