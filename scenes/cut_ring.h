#pragma once
/// The circle on one wall along which a pen is led, as the surgeon sees it on the tissue now, and where the wall has parted along it.
#include <vector>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted::scenes {

/// One direction of the circle: between two vertices of the side that the pen comes to.
struct RingColumn { int below = 0, above = 0; double share = 0.0; };   // [1] of the way from the base's side to the specimen's

struct CutRing {
  int wall = 0;                                // 0 outer, reached on its mucosa; 1 inner, on its serosa through the outer cut
  std::vector<RingColumn> column;              // counter-clockwise from +x
  std::vector<std::vector<int>> cell;          // per column: tets of the row that the circle runs through
  bool present() const { return column.size() >= 3; }
};

/// `fromLine` [m] from the planned line, positive toward the base. Not present where the wall has nothing to cut there.
CutRing ringOn(const Model&, int wall, double fromLine);

/// A place of the circle, turned by `columns` from +x.
struct RingPlace { Vec3 point = Vec3::Zero(), out = Vec3::UnitX(); };      // [m], [1] away from the axis, square to the wall
RingPlace placeOnRing(const CutRing&, const State&, double columns);      // [1]

Vec3 centreOf(const CutRing&, const State&);                              // [m] of the circle as it lies

/// What still holds the two sides together there, the nearest to the tip first: a tet of the circle's own row, as it lies, where it is as far
/// from the one edge as from the other. Only where that row has gone all the way round is anything free. False when all of it has gone: the wall has parted there.
struct Bridge { Vec3 middle = Vec3::Zero(); };                            // [m]
bool bridgeAt(const CutRing&, const Model&, const State&, int column, Bridge&);

}  // namespace halsted::scenes
