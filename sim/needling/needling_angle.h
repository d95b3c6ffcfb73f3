#pragma once
/// Angle between needle and skin, without libm.
#include "sim/step.h"

namespace halsted {

/// Arc sine of x in 0..1, within 1e-7: Abramowitz and Stegun 1964, 4.4.46.  x [1] -> [rad]
double arcSine(double x);

/// As the needle went in, or outside as it is held over the skin nearest to its tip.  [rad]
double needleAngle(const BodyModel&, const State&);

}  // namespace halsted
