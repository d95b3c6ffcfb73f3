#pragma once
/// Thread that lies over the thin edge of a wall: the way out across the thread. Physics thread; no heap.
#include <vector>

#include "sim/contact/surface.h"

namespace halsted {

/// A point of the thread within the tissue, and the surface nearest to it.
struct PressedIn {
  Vec3 point = Vec3::Zero(), along = Vec3::UnitX();   // [m]; [1] the thread's tangent
  SurfacePoint nearest;
  int vertex = 0;                              // round which to look
};

/// Where its nearest surface faces along the thread: the nearest bare triangle through which it leaves the tissue square to the thread, no
/// farther than `most` [m]; else the nearest surface itself. Pushed along itself thread would cut down into the wall like wire into cheese.
SurfacePoint exitAcross(const SurfaceModel&, const SurfaceNow&, const PressedIn&, double most);

inline constexpr int kEdgeFace = 2;            // of TetMesh::triangleLayer

/// The same through the wall's edge alone, wherever its nearest surface faces; none within `most` [m]: triangle -1. `layer`: of each triangle.
SurfacePoint exitOverEdge(const SurfaceModel&, const std::vector<int>& layer, const SurfaceNow&, const PressedIn&, double most);

}  // namespace halsted
