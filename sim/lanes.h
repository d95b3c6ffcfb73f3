#pragma once
/// Four independent double lanes on the compilers' vector extension. The same template body instantiated with `double` gives the
/// same bits lane by lane (no reassociation, no contraction), which a test proves (DESIGN 7.1).
#include <cmath>

namespace halsted {

using Lanes4 = double __attribute__((vector_size(32)));

#define HALSTED_INLINE inline __attribute__((always_inline))

HALSTED_INLINE double squareRoot(double x) { return std::sqrt(x); }   // [1]
HALSTED_INLINE Lanes4 squareRoot(Lanes4 x) {
  return Lanes4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
HALSTED_INLINE double magnitude(double x) { return std::fabs(x); }   // [1]
HALSTED_INLINE Lanes4 magnitude(Lanes4 x) { return x < 0.0 ? -x : x; }
HALSTED_INLINE Lanes4 larger(Lanes4 a, Lanes4 b) { return a < b ? b : a; }

template <typename L> struct LaneCount;
template <> struct LaneCount<double> { static constexpr int value = 1; };
template <> struct LaneCount<Lanes4> { static constexpr int value = 4; };

template <typename L> HALSTED_INLINE L loadLanes(const double* p);
template <> HALSTED_INLINE double loadLanes<double>(const double* p) { return *p; }
template <> HALSTED_INLINE Lanes4 loadLanes<Lanes4>(const double* p) { return Lanes4{p[0], p[1], p[2], p[3]}; }
inline constexpr double kZeros[4] = {};         // [1]
template <typename L> HALSTED_INLINE L zeroLanes() { return loadLanes<L>(kZeros); }
HALSTED_INLINE void storeLanes(double* p, double x) { *p = x; }   // [1]
/// In one piece: element by element, a compiler may undo the transposition before it and store one double at a time.
HALSTED_INLINE void storeLanes(double* p, Lanes4 x) { __builtin_memcpy(p, &x, sizeof x); }

}  // namespace halsted
