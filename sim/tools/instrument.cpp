#include "sim/tools/instrument.h"

#include "sim/contact/geometry.h"
#include "sim/step.h"
#include "sim/suture/holes.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kFree = 6e-3;                 // [m] between an instrument that is changed and whatever else there is

/// Is tissue, or the other hand's instrument, this near to an instrument of this shape?
bool inTheWay(const Model& m, const State& s, int hand, const ToolParams& tool) {
  const ToolState& t = s.tools[hand];
  const auto solids = worldSolids(m, s);
  for (const CapsuleShape& part : toolCapsules(tool, t.jaw)) {
    const CapsuleShape here = placed(part, t.proxy);
    const Vec3 along = here.b - here.a;        // [m]
    const double reach = here.radius + kFree;  // [m]
    if (tissueWithin(m, s, {here.a, here.b, reach})) return true;
    for (int k = 0; k < kSolids; ++k) {
      if (solidHand(k) == hand) continue;
      const auto at = closestSegments(here.a, here.b, solids[k].a, solids[k].b);
      const Vec3 apart = here.a + at[0] * along - solids[k].a - at[1] * (solids[k].b - solids[k].a);   // [m]
      const double least = reach + solids[k].radius;             // [m]
      if (apart.squaredNorm() < least * least) return true;
    }
  }
  return false;
}

InstrumentRefusal refusal(const Model& m, const State& s, int hand) {
  if (m.params.second[hand].kind == ToolKind::kNone) return InstrumentRefusal::kNoOther;
  if (!jawsEmpty(s.tools[hand])) return InstrumentRefusal::kHandFull;
  if (inTheWay(m, s, hand, m.params.tools[hand]) || inTheWay(m, s, hand, m.params.second[hand])) return InstrumentRefusal::kInTheWay;
  return InstrumentRefusal::kNone;
}

}  // namespace

void changeInstrument(const Model& m, int hand, State& s, StepOutput& out) {
  if (!s.instruments || hand < 0 || hand >= kHands) return;
  const InstrumentRefusal why = refusal(m, s, hand);
  s.instruments->refusal = static_cast<std::int32_t>(why);
  if (why != InstrumentRefusal::kNone) {
    pushEvent(out, {s.step, EventKind::kInstrumentRefused, hand, s.instruments->refusal, 0.0});
    return;
  }
  s.instruments->second[hand] = 1 - s.instruments->second[hand];
  s.tools[hand].contactCount = s.tools[hand].nearCount = 0;
  pushEvent(out, {s.step, EventKind::kInstrumentChanged, hand, s.instruments->second[hand], 0.0});
}

}  // namespace halsted
