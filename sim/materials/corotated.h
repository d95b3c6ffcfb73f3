#pragma once
/// Fixed corotated elasticity (Stomakhin et al. 2012, eqs. 2 and 3):  Psi = mu |F - R|^2 + lambda/2 (det F - 1)^2,  F = R S.
/// The energy that the projective solver minimises. Linear in the stretch: honest to about 30 % strain.
#include "sim/types.h"

namespace halsted {

struct Corotated { double mu = 0.0, lambda = 0.0; };                    // [Pa] Lame parameters

double energyDensity(const Corotated&, const Mat3& F);                  // F [1] -> [J/m^3]
Mat3 stress(const Corotated&, const Mat3& F);                           // first Piola-Kirchhoff, F [1] -> [Pa]
Mat3 stressDifferential(const Corotated&, const Mat3& F, const Mat3& dF);   // F, dF [1] -> [Pa]; finite for inverted and flat F

}  // namespace halsted
