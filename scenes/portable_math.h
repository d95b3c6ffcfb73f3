#pragma once
/// Sine and cosine from + - * / only. The C library's differ between processors in the last bit (DESIGN 7), and the rest shape of
/// an anatomy is part of every state hash.
#include <cmath>

namespace halsted::scenes {

inline constexpr double kPi = 3.14159265358979323846;  // [1]

namespace detail {
/// Taylor series on [-pi/4, pi/4]; the first dropped term is below 1e-17.
inline double sineSeries(double x) {  // x [rad]
  const double s = x * x;  // [1]
  double sum = 1.0;  // [1]
  for (int k = 17; k >= 3; k -= 2) sum = 1.0 - sum * s / (k * (k - 1));
  return x * sum;
}
inline double cosineSeries(double x) {  // x [rad]
  const double s = x * x;  // [1]
  double sum = 1.0;  // [1]
  for (int k = 18; k >= 2; k -= 2) sum = 1.0 - sum * s / (k * (k - 1));
  return sum;
}
}  // namespace detail

/// For |x| up to a few thousand radians, which is all that an anatomy asks.
inline double cosine(double x) {  // x [rad]
  const double quarter = std::floor(x / (0.5 * kPi) + 0.5);  // [1]
  const double rest = x - quarter * (0.5 * kPi);  // [rad]
  switch (static_cast<long>(quarter) & 3) {
    case 0: return detail::cosineSeries(rest);
    case 1: return -detail::sineSeries(rest);
    case 2: return -detail::cosineSeries(rest);
    default: return detail::sineSeries(rest);
  }
}
inline double sine(double x) { return cosine(x - 0.5 * kPi); }  // x [rad]

/// 0 below 0, 1 above 1, with two continuous derivatives between.
inline double smoothStep(double x) {  // x [1]
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

}  // namespace halsted::scenes
