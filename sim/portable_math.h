#pragma once
/// Sine, cosine and arc sine from + - * / and sqrt only: the C library's differ between processors in the last bit (DESIGN 7), and the
/// rest shape of an anatomy or a needle is part of every state hash.
#include <cmath>

namespace halsted {

inline constexpr double kPi = 3.14159265358979323846;  // [1]

/// Taylor series on [-pi/4, pi/4]; the first dropped term is below 1e-17.
inline double sineNearZero(double x) {  // x [rad]
  const double s = x * x;  // [1]
  double sum = 1.0;  // [1]
  for (int k = 17; k >= 3; k -= 2) sum = 1.0 - sum * s / (k * (k - 1));
  return x * sum;
}
inline double cosineNearZero(double x) {  // x [rad]
  const double s = x * x;  // [1]
  double sum = 1.0;  // [1]
  for (int k = 18; k >= 2; k -= 2) sum = 1.0 - sum * s / (k * (k - 1));
  return sum;
}

/// For |x| up to a few thousand radians, which is all that an anatomy asks.
inline double cosine(double x) {  // x [rad]
  const double quarter = std::floor(x / (0.5 * kPi) + 0.5);  // [1]
  const double rest = x - quarter * (0.5 * kPi);  // [rad]
  switch (static_cast<long>(quarter) & 3) {
    case 0: return cosineNearZero(rest);
    case 1: return -sineNearZero(rest);
    case 2: return -cosineNearZero(rest);
    default: return sineNearZero(rest);
  }
}
inline double sine(double x) { return cosine(x - 0.5 * kPi); }  // x [rad]

/// x [1], clamped to -1..1 -> [rad]. Newton on the sine, which is well conditioned up to 45 degrees; beyond, by the half angle.
inline double arcSine(double x) {
  if (x < 0.0) return -arcSine(-x);
  if (x > 0.7071) return 0.5 * kPi - 2.0 * arcSine(std::sqrt(0.5 * (1.0 - (x < 1.0 ? x : 1.0))));
  double angle = x;  // [rad]
  for (int i = 0; i < 5; ++i) angle -= (sineNearZero(angle) - x) / cosineNearZero(angle);  // quadratic: four reach the last bit
  return angle;
}

/// 0 below 0, 1 above 1, with two continuous derivatives between.
inline double smoothStep(double x) {  // x [1]
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

}  // namespace halsted
