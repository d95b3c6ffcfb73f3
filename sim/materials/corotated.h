#pragma once
/// Corotated linear elasticity (Mueller and Gross 2004; Sifakis and Barbic 2012, eq. 3.5), F = R S:
///   Psi = mu |F - R|^2 + lambda/2 tr(S - I)^2
/// The energy that the projective solver minimises. Linear in the stretch: P = E (stretch - 1) in a pulled strip of nu = 0.
/// With stiffening k > 1 bilinear in e = |F - R|, J-shaped as collagenous walls are: slope 2 mu within the toe e0, 2 k mu past it,
///   mu e^2 becomes mu (k e^2 - (k - 1) (2 e e0 - e0^2)).
#include "sim/types.h"

namespace halsted {

struct Corotated {
  double mu = 0.0, lambda = 0.0;               // [Pa] Lame parameters within the toe
  double stiffening = 1.0, toe = 1.0;          // [1] k, e0
};

/// Stress over that of the toe's straight line, 2 mu e.  [1] [1]
inline double secantFactor(const Corotated& m, double strain) {
  return strain <= m.toe ? 1.0 : m.stiffening - (m.stiffening - 1.0) * m.toe / strain;
}

double energyDensity(const Corotated&, const Mat3& F);                  // F [1] -> [J/m^3]
Mat3 stress(const Corotated&, const Mat3& F);                           // first Piola-Kirchhoff, F [1] -> [Pa]
Mat3 stressDifferential(const Corotated&, const Mat3& F, const Mat3& dF);   // F, dF [1] -> [Pa]; finite for inverted and flat F

}  // namespace halsted
