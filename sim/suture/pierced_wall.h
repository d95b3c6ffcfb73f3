#pragma once
/// Thread that has been flung or pushed right through a wall where no hole leads it. Physics thread; no heap.
#include "sim/contact/surface.h"
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Thread between `node` and the one before, which belong to opposite faces of one wall, goes through it too far from its edge to be let out there: pushed
/// out on either side they would pinch the wall between them for good. The one from which less thread leads to an end or to a hole comes through to
/// the other's side, and the next after it. Not while it is held on both ways, by holes or hands: drawn thread cuts into the folds that it gathers. Not
/// where tissue is cut: there thread leaves it across itself (strand_sample.h). Thread that can be knotted only between two bowels: over the edge of a
/// single wall a push along it hooks it. `before`, `now`: the tissue nearest to the two (`nearTissue`). Needs the faces' layers.
void drawBack(const Model&, int node, const SurfacePoint& before, const SurfacePoint& now, State&);

/// Is this node of thread that is not tied being drawn back? It comes at a pace (strand_contacts.cpp), other than thread that has only cut in.
bool comesThrough(const StrandState&, int sample);

/// It is out of the wall.
void hasComeThrough(int sample, StrandState&);

}  // namespace halsted
