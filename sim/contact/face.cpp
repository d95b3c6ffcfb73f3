#include "sim/contact/face.h"

#include <bit>

#include "sim/lane_math.h"

namespace halsted {
namespace {

using Two = double __attribute__((vector_size(16)));   // SSE2, which every x86-64 has

template <typename V> constexpr int kSide = sizeof(V) / sizeof(double);   // vertices side by side

template <typename V> HALSTED_INLINE V several(double x) { return x - V{}; }   // [any]
template <typename V> HALSTED_INLINE V loadSeveral(const double* p) {
  V v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}

/// What of a face tells which vertices are inside, for several side by side.
template <typename V> struct Ball {
  V normal[3], centre[3];                      // [1], [m]
  V above, below, squaredReach;                // [m], [m], [m^2]
};

template <typename V> HALSTED_INLINE Ball<V> ballOf(const Face& f) {
  Ball<V> b;
  for (int axis = 0; axis < 3; ++axis) {
    b.normal[axis] = several<V>(f.normal[axis]);
    b.centre[axis] = several<V>(f.centre[axis]);
  }
  b.above = several<V>(f.above);
  b.below = several<V>(-f.behind);
  b.squaredReach = several<V>(f.squaredReach);
  return b;
}

/// The three comparisons of a face, lane by lane. Each on its own: joined as vectors first, gcc takes them apart into single numbers.
template <typename V> struct Heights { V height, square; };      // [m], [m^2]
template <typename V> HALSTED_INLINE Heights<V> heights(const Ball<V>& b, const double* x, const double* y, const double* z) {   // [m]
  const V dx = loadSeveral<V>(x) - b.centre[0], dy = loadSeveral<V>(y) - b.centre[1], dz = loadSeveral<V>(z) - b.centre[2];
  return {dx * b.normal[0] + dy * b.normal[1] + dz * b.normal[2], dx * dx + dy * dy + dz * dz};
}

HALSTED_INLINE int append(int bits, int e, int to, const SelfWork& w, int count, std::int32_t* inside) {
  for (; bits != 0; bits &= bits - 1) {
    const int at = e + std::countr_zero(static_cast<unsigned>(bits));
    if (at < to) inside[count++] = w.item[at];
  }
  return count;
}

int insideNarrow(const Face& f, int from, int to, SelfWork& w) {
  const Ball<Two> b = ballOf<Two>(f);
  const double *x = w.place.data(), *y = x + w.item.size(), *z = y + w.item.size();
  const auto bits = [](auto mask) { return __builtin_ia32_movmskpd(std::bit_cast<Two>(mask)); };
  int count = 0;
  for (int e = from; e < to; e += kSide<Two>) {
    const Heights<Two> h = heights(b, x + e, y + e, z + e);
    count = append(bits(h.height < b.above) & bits(h.height > b.below) & bits(h.square < b.squaredReach), e, to, w, count, w.inside.data());
  }
  return count;
}

__attribute__((target("avx2"))) int insideWide(const Face& f, int from, int to, SelfWork& w) {
  const Ball<Lanes4> b = ballOf<Lanes4>(f);
  const double *x = w.place.data(), *y = x + w.item.size(), *z = y + w.item.size();
  int count = 0;
  for (int e = from; e < to; e += kSide<Lanes4>) {
    const Heights<Lanes4> h = heights(b, x + e, y + e, z + e);
    const auto above = h.height < b.above, behind = h.height > b.below, far = h.square < b.squaredReach;
    Lanes4 inside;
    const auto all = above & behind & far;
    __builtin_memcpy(&inside, &all, sizeof inside);
    count = append(__builtin_ia32_movmskpd256(inside), e, to, w, count, w.inside.data());
  }
  return count;
}

}  // namespace

int insideRun(const Face& face, int from, int to, SelfWork& w) {
  static const bool wide = widestLanes() == LanePath::kWide;     // the same entries without
  return wide ? insideWide(face, from, to, w) : insideNarrow(face, from, to, w);
}

}  // namespace halsted
