#include "sim/tools/cutter.h"

#include "sim/lanes.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/tools/instrument.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kBladeFrom = 8.0e-3, kBladeTo = 11.5e-3;        // [m] from the tips: behind what grips
constexpr double kBladeWidth = 1.0e-3;         // [m] across, to either side: a loop round the outside of the jaws is not between them

/// `jaw`: the one at +x, in the tool frame as `p` [m]. Past the jaws' middle lines is their outside: turns of a tie lie there.
bool betweenBlades(const CapsuleShape& jaw, const Vec3& p) {
  const double share = p.z() / jaw.b.z();      // [1] of the way from the tip to the hinge
  const double open = (1.0 - share) * jaw.a.x() + share * jaw.b.x();   // [m]
  return p.z() > kBladeFrom && p.z() < kBladeTo && magnitude(p.y()) < kBladeWidth && magnitude(p.x()) < open;
}

}  // namespace

int threadBetweenBlades(const Model& m, int hand, const State& s) {
  if (!toolOf(m, s, hand).cutter || s.threadContacts.cut.empty()) return -1;
  constexpr int kSamples = 4;                  // per segment
  const CapsuleShape jaw = toolCapsules(toolOf(m, s, hand), s.tools[hand].jaw)[0];
  for (int i = 0; i + 1 < m.strand.nodes; ++i) {
    if (s.threadContacts.cut[i]) continue;
    for (int k = 0; k < kSamples; ++k) {
      const double share = (k + 0.5) / kSamples;                 // [1]
      const Vec3 p = (1.0 - share) * s.strand.position[i] + share * s.strand.position[i + 1];
      if (betweenBlades(jaw, s.tools[hand].proxy.inverseApply(p))) return i;
    }
  }
  return -1;
}

bool cutThread(const Model& m, int hand, State& s, StepOutput& out) {
  const int i = threadBetweenBlades(m, hand, s);
  if (i < 0) return false;
  s.threadContacts.cut[i] = 1;
  s.strand.tension[i] = 0.0;
  ++s.knot.cuts;
  pushEvent(out, {s.step, EventKind::kThreadCut, hand, i, 0.0});
  return true;
}

}  // namespace halsted
