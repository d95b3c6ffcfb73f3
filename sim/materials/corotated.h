#pragma once
/// Corotated linear elasticity (Mueller and Gross 2004; Sifakis and Barbic 2012, eq. 3.5), F = R S:
///   Psi = mu |F - R|^2 + lambda/2 tr(S - I)^2
/// The energy that the projective solver minimises. Linear in the stretch: P = E (stretch - 1) in a pulled strip of nu = 0.
#include "sim/types.h"

namespace halsted {

struct Corotated { double mu = 0.0, lambda = 0.0; };                    // [Pa] Lame parameters

double energyDensity(const Corotated&, const Mat3& F);                  // F [1] -> [J/m^3]
Mat3 stress(const Corotated&, const Mat3& F);                           // first Piola-Kirchhoff, F [1] -> [Pa]
Mat3 stressDifferential(const Corotated&, const Mat3& F, const Mat3& dF);   // F, dF [1] -> [Pa]; finite for inverted and flat F

}  // namespace halsted
