#pragma once
/// Where the hands of an instrument tie stand, seen from the stitch. Private to scenes/.
#include "scenes/expert_state.h"
#include "sim/strand/strand_state.h"

namespace halsted::scenes {

/// Holes at which the tail and the long end leave the tissue.
const Hole& tailHole(const Scene&);
const Hole& longHole(const Scene&);

/// Middle between the two places where the ends leave the tissue.
Vec3 stitch(const Scene&);                     // [m]
/// Clear of the tissue about the stitch: so high above it.
double overTissue(const Scene&);               // [m]
/// Is there room under the driver, where it is wound?
bool mayStandLower(const Scene&);
/// The driver's shaft, from the tips to the handle.
Vec3 driverShaft(const Scene&);                // [1]

Pose keepTurn(const Scene&, int hand, const Vec3& position);   // [m]
/// Where the hand is, its shaft away from the walls.
Pose upright(const Scene&, int hand);
bool standsUpright(const Scene&, int hand);
/// The tips of the driver while it is wound; and so far back along its shaft.
Vec3 driverPlace(const Scene&);                // [m]
Pose driverPose(const Scene&, double back);    // [m]
/// The winding hand, having gone so far round the driver, its thread all but straight if that is not too far. `driver`: the tips.
Pose windingPose(const Scene&, const Vec3& driver, double swept);   // [m], [rad]
double wholeTurns(const Scene&);               // [rad]
/// How much longer than its straight way the lifted long end is near its hole, where it goes over an edge first.
double detour(const Scene&);                   // [m]

/// Coordinates at which the ends are to be taken.
double tailPlace(const Scene&);                // [m]
double longPlace(const Scene&);                // [m]
bool holdsLong(const Scene&);
/// The winding hand has the long end, farther from the stitch than that.
bool holdsTooFar(const Scene&);
/// Has the needle, cut off, stayed at the jaws that hold the long end?
bool needleClings(const Scene&);
bool driverHoldsLong(const Scene&);
bool holdsTail(const Scene&);
/// Does the long end still lie about the driver, on the side of its tips?
bool loopOnJaws(const Scene&);
/// How often the long end goes round the driver's jaws, tips to hinge and beyond, as far as the hand that winds it; a quarter when it only
/// passes by.  [1]
double woundRoundDriver(const Scene&);
/// Grip on the tail from the driver's side.
Pose tailGrip(const Scene&);

}  // namespace halsted::scenes
