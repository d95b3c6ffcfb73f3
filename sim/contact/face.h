#pragma once
/// A triangle's first question to many vertices, most of which it rejects: is it between two planes and inside a ball? No heap.
#include "sim/types.h"
#include "sim/work.h"

namespace halsted {

/// A triangle made ready to reject most vertices by its plane and its ball.
struct Face {
  int index = 0, next = 0;                       // triangle; the pairs of the last round from here on belong to later ones
  bool held = false;                             // all three corners are fixed
  Vec3 a, b, c, normal, centre;                  // [m] corners; [1]; [m]
  double above = 0.0, behind = 0.0;              // [m] heights between which a vertex is of interest
  double squaredReach = 0.0;                     // [m^2] about the centre
};

inline bool insideBall(const Face& f, const Vec3& p) {   // p [m]
  const Vec3 d = p - f.centre;
  const double height = d.dot(f.normal);         // [m]
  // One branch instead of three: which of them fails is as good as random.
  return (height < f.above) & (height > -f.behind) & (d.squaredNorm() < f.squaredReach);
}

/// Entries of a run `from` .. `to` of `w.item` that are inside, in order, into `w.inside`; returns how many.
int insideRun(const Face&, int from, int to, SelfWork& w);

}  // namespace halsted
