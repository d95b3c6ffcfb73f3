#pragma once
/// A triangle's first question to many vertices, most of which it rejects: is it between two planes and inside a ball?
#include <bit>

#include "sim/lanes.h"
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

using Two = double __attribute__((vector_size(16)));   // SSE2, which every x86-64 has

HALSTED_INLINE Two loadTwo(const double* p) { return Two{p[0], p[1]}; }
HALSTED_INLINE Two twice(double x) { return Two{x, x}; }   // [any]

/// What of a face tells which vertices are inside, for two side by side.
struct Ball {
  explicit Ball(const Face& f) : above(twice(f.above)), below(twice(-f.behind)), squaredReach(twice(f.squaredReach)) {
    for (int axis = 0; axis < 3; ++axis) {
      normal[axis] = twice(f.normal[axis]);
      centre[axis] = twice(f.centre[axis]);
    }
  }
  Two normal[3], centre[3];                      // [1], [m]
  Two above, below, squaredReach;                // [m], [m], [m^2]
};

/// One bit a lane. Each comparison on its own: joined as vectors first, gcc takes them apart into single numbers.
HALSTED_INLINE int bits(auto mask) { return __builtin_ia32_movmskpd(std::bit_cast<Two>(mask)); }
/// The same for two vertices: bit 0 and bit 1.
HALSTED_INLINE int insideBall(const Ball& b, const double* x, const double* y, const double* z) {   // [m]
  const Two dx = loadTwo(x) - b.centre[0], dy = loadTwo(y) - b.centre[1], dz = loadTwo(z) - b.centre[2];
  const Two height = dx * b.normal[0] + dy * b.normal[1] + dz * b.normal[2];
  return bits(height < b.above) & bits(height > b.below) & bits(dx * dx + dy * dy + dz * dz < b.squaredReach);
}

/// Of the four entries from `e` on, those before `end`.
HALSTED_INLINE int insideBall(const Ball& b, const SelfWork& w, int e, int end) {
  const double *x = w.place.data() + e, *y = x + w.item.size(), *z = y + w.item.size();
  const int four = insideBall(b, x, y, z) | insideBall(b, x + 2, y + 2, z + 2) << 2;
  return end - e < 4 ? four & ((1 << (end - e)) - 1) : four;
}

}  // namespace halsted
