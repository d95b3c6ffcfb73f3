#pragma once
/// Real orthonormal spherical harmonics of a unit vector, by recurrences in x, y and z: + - * / only, no angle.
///   Y_lm = p_l|m|(z) C_m(x, y) for m >= 0,  p_l|m|(z) S_|m|(x, y) for m < 0,   C_m + i S_m = (x + i y)^m,
/// with p the associated Legendre function without its factor (1 - z^2)^(m/2), which C and S carry, so that poles are not special.
/// Normalisation and m = 0 as in acupuncture-force-net 2021, eqs. 1 and 2; the real pair of each m > 0 is sqrt(2) times the real
/// and the imaginary part, without the sign (-1)^m. The column recurrence in l is the stable one (Holmes and Featherstone 2002).
#include <span>
#include <vector>

#include "sim/types.h"

namespace halsted {

inline constexpr int kMaxHarmonicOrder = 64;   // tested to here; (order + 1)^2 functions

constexpr int harmonicCount(int order) { return (order + 1) * (order + 1); }
constexpr int harmonicIndex(int l, int m) { return l * l + l + m; }   // from 0; eq. 4 counts from 1

/// Numbers of the recurrence p_lm = a_lm (z p_(l-1)m - b_lm p_(l-2)m), column by column: m = 0, l = 0..order; m = 1, l = 1..order; ...
struct HarmonicTables {
  int order = 0;
  std::vector<double> a, b;                    // [1]
  std::vector<double> first;                   // [1] p_mm
};

/// Throws std::invalid_argument when the order is outside 0..kMaxHarmonicOrder.
HarmonicTables harmonicTables(int order);

/// Place of (l, m), m >= 0, in the columns.
constexpr int harmonicColumn(int order, int l, int m) { return m * (order + 1) - m * (m - 1) / 2 + (l - m); }

/// All (order + 1)^2 functions at a unit vector, in the order of harmonicIndex.  values [1]
void harmonics(const HarmonicTables&, const Vec3& unit, std::span<double> values);

}  // namespace halsted
