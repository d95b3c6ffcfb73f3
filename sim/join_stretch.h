#pragma once
/// The sewn part of an edge, and how it lies. Private to sim/join and sim/whole_seam.
#include <span>

#include "sim/join.h"
#include "sim/model.h"

namespace halsted {

/// The columns from stitch to stitch on one bowel.
struct SewnStretch { int first = 0, count = 0; };

/// Which rim column is nearest to a point at rest.  [m]
int columnNear(const Model&, int bowel, const Vec3& rest);

/// Widest gaps along it, and the turn of its edge added to `inversion`.
void measureStretch(const Model&, const State&, int bowel, const SewnStretch&, JoinMetrics&);

}  // namespace halsted
