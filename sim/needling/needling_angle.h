#pragma once
/// Angle between needle and skin, without libm.
#include "sim/step.h"

namespace halsted {

/// As the needle went in, or outside as it is held over the skin nearest to its tip.  [rad]
double needleAngle(const BodyModel&, const State&);

}  // namespace halsted
