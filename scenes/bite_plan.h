#pragma once
/// Where a bite goes and how the needle must move for it: rotation of the arc about its own centre.
#include "scenes/expert.h"

namespace halsted::scenes {

/// A place on the tissue that moves with it.
struct TissuePlace {
  int triangle = -1;
  std::array<double, 3> weight{};              // [1]
};

inline constexpr int kSerosa = 0, kMucosa = 1;   // of TetMesh::triangleLayer

/// A direction and a depth on one of the scene's bowels, on its serosa or its mucosa.
struct WallSpot { int bowel = 0; double angleDegrees = 0.0, depth = 0.0; int layer = kSerosa; };   // [deg] round its opening, [m] behind its rim

/// Outermost wall there, in the anatomy at rest. triangle -1: there is none.
TissuePlace placeOnWall(const Model&, const WallSpot&);
/// How far behind its rim a bowel ends now in a direction: what a cut has left.  [m] [deg]
double edgeBehindRim(const Model&, const State&, int bowel, double angleDegrees);
Vec3 positionOf(const Model&, const State&, const TissuePlace&);            // [m]
Vec3 normalOf(const Model&, const State&, const TissuePlace&);              // [1] outward

/// The circle that the needle runs along, fixed in space once the surgeon has looked.
struct BitePlan {
  TissuePlace entry, exit;
  double middleDegrees = 0.0;                  // [deg] half way between them
  Vec3 centre = Vec3::Zero();                  // [m] of the arc
  Vec3 along = Vec3::UnitX(), out = Vec3::UnitY(), axis = Vec3::UnitZ();    // [1] entry to exit; out of the wall; of the rotation
  double entryAngle = 0.0, exitAngle = 0.0;    // [rad] of the tip on the circle, 0 at the deepest point
};

/// False when the wall has no such place or the needle is too small for the width.
bool planPlaces(const Model&, const ExpertAction&, BitePlan&, const State* cut = nullptr);   // `cut`: depths across count from what a cut has left
/// Looks at the tissue as it lies now; `dip` sets the circle deeper than the places ask, for the wall dimples.  [m] [m]
void planCircle(const Model&, const State&, const ExpertAction&, double dip, BitePlan&);

/// Needle pose with its tip at an angle on the circle, the circle moved by `offset` [m].
Pose needleOnCircle(const Model&, const BitePlan&, double tipAngle, const Vec3& offset);   // [rad]

/// Tool pose that grips the needle at a strand coordinate square to it: shaft along the needle's axis, jaws opening radially.
Pose gripPose(const Model&, const Pose& needle, double coordinate);   // [m]

}  // namespace halsted::scenes
