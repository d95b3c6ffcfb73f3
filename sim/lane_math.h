#pragma once
/// Small vector algebra on four independent lanes, for kernels that treat four tets or clusters at once. `L` is `Lanes4` (the
/// compilers' vector extension) or `Serial4` (four plain doubles): each lane sees the same operations in the same order, so both give
/// the same bits, and a test compares them (DESIGN 7.1).
#include "sim/lanes.h"

namespace halsted {

/// Which instructions a kernel uses; the bits are the same.
enum class LanePath : unsigned char { kSerial, kWide };   // plain doubles; AVX2

inline LanePath widestLanes() { return __builtin_cpu_supports("avx2") ? LanePath::kWide : LanePath::kSerial; }

/// The scalar reference: four doubles, one after the other.
struct Serial4 {
  double v[4];                                             // [any]

  HALSTED_INLINE double operator[](int i) const { return v[i]; }
};

#define HALSTED_SERIAL_OPERATOR(op)                                                                               \
  HALSTED_INLINE Serial4 operator op(Serial4 a, Serial4 b) {                                                      \
    return {{a.v[0] op b.v[0], a.v[1] op b.v[1], a.v[2] op b.v[2], a.v[3] op b.v[3]}};                            \
  }                                                                                                               \
  HALSTED_INLINE Serial4 operator op(Serial4 a, double b) { return a op Serial4{{b, b, b, b}}; }   /* [any] */    \
  HALSTED_INLINE Serial4 operator op(double a, Serial4 b) { return Serial4{{a, a, a, a}} op b; }   /* [any] */
HALSTED_SERIAL_OPERATOR(+)
HALSTED_SERIAL_OPERATOR(-)
HALSTED_SERIAL_OPERATOR(*)
HALSTED_SERIAL_OPERATOR(/)
#undef HALSTED_SERIAL_OPERATOR
HALSTED_INLINE Serial4 operator-(Serial4 a) { return {{-a.v[0], -a.v[1], -a.v[2], -a.v[3]}}; }
HALSTED_INLINE Serial4 squareRoot(Serial4 x) { return {{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])}}; }
HALSTED_INLINE Serial4 magnitude(Serial4 x) { return {{std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2]), std::fabs(x[3])}}; }

/// Lane by lane: limit < x ? a : b. A lane that is not a number takes b.
HALSTED_INLINE Lanes4 selectAbove(Lanes4 x, Lanes4 limit, Lanes4 a, Lanes4 b) { return limit < x ? a : b; }
HALSTED_INLINE Serial4 selectAbove(Serial4 x, Serial4 limit, Serial4 a, Serial4 b) {
  Serial4 out;
  for (int i = 0; i < 4; ++i) out.v[i] = limit.v[i] < x.v[i] ? a.v[i] : b.v[i];
  return out;
}

template <> struct LaneCount<Serial4> { static constexpr int value = 4; };
template <> HALSTED_INLINE Serial4 loadLanes<Serial4>(const double* p) { return {{p[0], p[1], p[2], p[3]}}; }
HALSTED_INLINE void storeLanes(double* p, Serial4 x) { p[0] = x[0]; p[1] = x[1]; p[2] = x[2]; p[3] = x[3]; }

/// Four rows of four doubles, seen column by column.
template <typename L> struct LaneRows { L x, y, z, w; };

HALSTED_INLINE LaneRows<Lanes4> transpose(const LaneRows<Lanes4>& r) {
  const Lanes4 a = __builtin_shufflevector(r.x, r.y, 0, 4, 2, 6), b = __builtin_shufflevector(r.x, r.y, 1, 5, 3, 7);
  const Lanes4 c = __builtin_shufflevector(r.z, r.w, 0, 4, 2, 6), d = __builtin_shufflevector(r.z, r.w, 1, 5, 3, 7);
  return {__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(b, d, 0, 1, 4, 5),
          __builtin_shufflevector(a, c, 2, 3, 6, 7), __builtin_shufflevector(b, d, 2, 3, 6, 7)};
}
HALSTED_INLINE LaneRows<Serial4> transpose(const LaneRows<Serial4>& r) {
  return {{{r.x[0], r.y[0], r.z[0], r.w[0]}}, {{r.x[1], r.y[1], r.z[1], r.w[1]}},
          {{r.x[2], r.y[2], r.z[2], r.w[2]}}, {{r.x[3], r.y[3], r.z[3], r.w[3]}}};
}

/// Lane l of the result holds row index[l] of an array of rows.
template <typename L> HALSTED_INLINE LaneRows<L> gatherRows(const double* rows, const int* index) {
  return transpose(LaneRows<L>{loadLanes<L>(rows + 4 * index[0]), loadLanes<L>(rows + 4 * index[1]),
                               loadLanes<L>(rows + 4 * index[2]), loadLanes<L>(rows + 4 * index[3])});
}
template <typename L> HALSTED_INLINE void scatterRows(double* rows, const int* index, const LaneRows<L>& columns) {
  const LaneRows<L> r = transpose(columns);
  storeLanes(rows + 4 * index[0], r.x);
  storeLanes(rows + 4 * index[1], r.y);
  storeLanes(rows + 4 * index[2], r.z);
  storeLanes(rows + 4 * index[3], r.w);
}

template <typename L> struct LaneVec { L x, y, z; };
template <typename L> HALSTED_INLINE LaneVec<L> operator+(const LaneVec<L>& a, const LaneVec<L>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <typename L> HALSTED_INLINE LaneVec<L> operator-(const LaneVec<L>& a, const LaneVec<L>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <typename L> HALSTED_INLINE LaneVec<L> operator*(L s, const LaneVec<L>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <typename L> HALSTED_INLINE L dot(const LaneVec<L>& a, const LaneVec<L>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <typename L> HALSTED_INLINE LaneVec<L> cross(const LaneVec<L>& a, const LaneVec<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Matrix as its three columns.
template <typename L> struct LaneMat { LaneVec<L> c0, c1, c2; };

}  // namespace halsted
