#pragma once
/// Stable neo-Hookean elasticity (Smith, de Goes and Kim 2018, eq. 14, without the logarithm; Macklin and Mueller 2021):
///   Psi = mu/2 (|F|^2 - 3) + l/2 (det F - 1 - mu/l)^2 - mu^2/(2 l),  l = lambda + mu.
/// With l instead of lambda the response to small strains is Hooke's. The energy that the XPBD solver minimises.
#include "sim/types.h"

namespace halsted {

struct StableNeoHookean { double mu = 0.0, lambda = 0.0; };             // [Pa] Lame parameters

double energyDensity(const StableNeoHookean&, const Mat3& F);           // F [1] -> [J/m^3]
Mat3 stress(const StableNeoHookean&, const Mat3& F);                    // first Piola-Kirchhoff, F [1] -> [Pa]
Mat3 stressDifferential(const StableNeoHookean&, const Mat3& F, const Mat3& dF);   // F, dF [1] -> [Pa]; finite for any F

}  // namespace halsted
