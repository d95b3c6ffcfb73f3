#pragma once
/// Points of the strand that may lie against something, and the tissue nearest to them: the thread's nodes, samples of the needle, and
/// points half-way between two nodes where thread lies over the edge of a wall. Physics thread; no heap.
#include "sim/contact/surface.h"
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kSkinDepth = 3e-3;     // [m] a sample pressed in no deeper goes back out on the side that it came from

struct StrandSample {
  int index = 0;                               // thread node, nodes + needle sample, or all of these + the node before which it lies half-way
  double coordinate = 0.0, radius = 0.0;       // [m]
  Vec3 position = Vec3::Zero(), predicted = Vec3::Zero();   // [m] at the start of the step; where inertia takes it
  bool thread = true, isTip = false;
};

int sampleCount(const StrandModel&);           // nodes and samples of the needle
StrandSample sampleAt(const Model&, const StrandState&, int index);

/// Half-way from the node before, `node` > 0.
StrandSample sampleBetween(const Model&, const StrandState&, int node);

/// The surface vertex from which a sample's way over the tissue is followed; what was known of another bowel stays known.
void follow(const Model&, int sample, int vertex, StrandState&);

/// Where the tissue is nearest to a node or a sample of the needle; none within reach, or where a hole leads it: triangle -1.
SurfacePoint nearTissue(const Model&, const StrandSample&, State&);

/// The face by which a sample goes into the tissue on its way from `position` to `predicted`, where it does not come out of it; else triangle -1.
SurfacePoint faceOnWay(const Model&, const StrandSample&, State&);

/// The way out across the thread, of a point pressed in no deeper than the skin; `near` as it is where there is none.
SurfacePoint outAcross(const Model&, const StrandSample&, const SurfacePoint& near, const State&);

/// Where a point between two nodes leaves the tissue over the wall's edge: pushed out of either face, beside a node that is pushed out of the other, it
/// would wedge the thread in the wall. None: triangle -1. Needs the faces' layers.
SurfacePoint nearBetween(const Model&, const StrandSample&, int node, const State&);

/// Are these triangles the serosa and the mucosa of one bowel?
bool oppositeFaces(const Model&, int triangle, int other);

/// Do two neighbouring nodes lie on the tissue, on opposite faces, so that thread between them lies over an edge?
bool overEdge(const Model&, const SurfacePoint&, const SurfacePoint&);

}  // namespace halsted
