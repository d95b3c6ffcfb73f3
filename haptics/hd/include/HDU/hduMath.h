/* Small functions on numbers, vectors and lines. */
#ifndef HALSTED_HDU_MATH_H
#define HALSTED_HDU_MATH_H

#include <float.h>
#include <math.h>

#ifdef __cplusplus

template <class T> inline T hduMin(const T &a, const T &b) { return b < a ? b : a; }
template <class T> inline T hduMax(const T &a, const T &b) { return a < b ? b : a; }
template <class T> inline T hduAbsValue(const T &value) { return value < T(0) ? T(-value) : value; }

template <class T> inline T hduClamp(const T &value, const T &low, const T &high) {
  return value < low ? low : high < value ? high : value;
}

/* To the nearest integer, halves away from zero. */
inline int hduRound(double value) { return static_cast<int>(value < 0.0 ? ceil(value - 0.5) : floor(value + 0.5)); }

template <class T> inline bool hduIsEqual(const T &a, const T &b, const T &epsilon) { return hduAbsValue(T(a - b)) <= epsilon; }

/* From a at t = 0 to b at t = 1. */
template <class T, class S> inline T hduLerp(const T &a, const T &b, S t) { return a + (b - a) * t; }

/* The point at parameter t of the line through p with direction d. */
template <class T, class S> inline T hduEvalLine(const T &p, const T &d, S t) { return p + d * t; }

#endif

#endif
