#pragma once
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Refreshes the list of triangles near a tool every few steps.
void refreshNear(const Model&, int hand, State&);

/// Appends the tool's contacts and grasps at the predicted tissue to `work.touch`.
void findContacts(const Model&, int hand, const Pose& before, State&);
void findGrasps(const Model&, int hand, State&);

}  // namespace halsted
