#pragma once
#include <span>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// No tool and no tissue moves farther in a step: so far ahead of a tool contacts are looked for.  [m]
inline constexpr double kFastest = 1e-3;

/// Refreshes the list of triangles near a tool every few steps.
void refreshNear(const Model&, int hand, State&);
void listNearTriangles(const Model&, int hand, State&);   // at once

/// What each contact of a tool takes back in a step of the penetration with which that begins, where tissue is cut: less where it pushes the tool from both
/// sides.  [m]
double recovered(const ToolState&);

/// Appends the tool's contacts and grasps at the predicted tissue to `work.touch`.
void findContacts(const Model&, int hand, const Pose& before, State&);
void findGrasps(const Model&, int hand, State&);

/// Appends what a pair of jaws holds; `holder` as in TouchPoint.
void appendGrasp(const Model&, int holder, const Pose& jaws, double gripForce, const TissueGrasp&, State&);   // [N]

/// Does a triangle share a corner with one that is held?
bool isHeld(const Model&, const TissueGrasp&, int triangle);

/// Where the tool would touch first, nearest first, within `margin` [m] of its surface: at most one point for each way it may go.
/// Returns how many.
int findAhead(const Model&, int hand, const State&, double margin, std::span<TouchPoint> found);

}  // namespace halsted
