#pragma once
/// The surfaces of the layers at the needle: dimpled by the tip, springing back after it has gone through.
#include "sim/needling/needling.h"

namespace halsted {

/// Lays a layer's net round a point of its surface and starts the dimple.
void layNet(const NeedlingModel&, int layer, const SurfaceFrame&, NeedlingState&);

/// Moves the net's points to the dimple of depth `depth` [m] along the axis; returns eq. 6 over the points themselves.  [N]
double pressNet(const NeedlingModel&, int layer, double depth, NeedlingState&);

/// A punctured surface springs back toward what friction `held` [N] (along the axis, inward) still carries.
void releaseNet(const NeedlingModel&, int layer, double held, NeedlingState&);

/// Shaft inside each layer, from the tip's depth and the present surfaces.  [m]
std::array<double, kLayers> shaftInside(const NeedlingState&);

/// Where the needle's line meets each layer's surface at rest; a layer that it does not meet lies out of reach.
void findCrossings(const NeedlingModel&, NeedlingState&);

}  // namespace halsted
