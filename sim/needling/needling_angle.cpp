#include "sim/needling/needling_angle.h"

#include "sim/portable_math.h"

namespace halsted {

double needleAngle(const BodyModel& m, const State& s) {
  const NeedlingState& n = *s.needling;
  if (n.layers[0].phase == LayerPhase::kPunctured) return arcSine(-n.axis.dot(n.outward));
  return arcSine((s.tools[m.needleHand].device.orientation * Vec3::UnitZ()).dot(n.outward));
}

}  // namespace halsted
