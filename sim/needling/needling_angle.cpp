#include "sim/needling/needling_angle.h"

#include <cmath>

namespace halsted {

double arcSine(double x) {
  constexpr double kHalfPi = 1.5707963267948966;   // [rad]
  constexpr double kA[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046, 0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  const double c = x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;   // [1]
  double sum = 0.0;                            // [rad]
  for (int k = 7; k >= 0; --k) sum = sum * c + kA[k];
  return kHalfPi - std::sqrt(1.0 - c) * sum;
}

double needleAngle(const BodyModel& m, const State& s) {
  const NeedlingState& n = *s.needling;
  if (n.layers[0].phase == LayerPhase::kPunctured) return arcSine(-n.axis.dot(n.outward));
  return arcSine((s.tools[m.needleHand].device.orientation * Vec3::UnitZ()).dot(n.outward));
}

}  // namespace halsted
