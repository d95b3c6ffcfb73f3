#pragma once
/// Keeps two particles `restLength` apart:  C(x) = |x1 - x0| - restLength  [m].
/// Macklin, Mueller and Chentanez 2016 (XPBD), eqs. 17 and 18.
#include "sim/constraints/constraint.h"

namespace halsted {

struct DistanceConstraints {                   // constant during a step
  std::vector<std::array<int, 2>> particles;   // sorted by colour, then index
  std::vector<double> restLength;              // [m]
  std::vector<double> compliance;              // [m/N] 0 = rigid
};

int size(const DistanceConstraints&);
void project(const DistanceConstraints&, double h, Particles&);                            // h [s]
void project(const DistanceConstraints&, double h, Particles&, std::span<double> multiplier);   // h [s], multiplier [N s^2]
/// Of the compliant constraints; a rigid one stores none.  [J]
double energy(const DistanceConstraints&, const Particles&);
static_assert(Constraint<DistanceConstraints>);

/// One constraint per pair, at its present length.  compliance [m/N]
DistanceConstraints makeDistanceConstraints(const std::vector<std::array<int, 2>>& pairs, const Particles&, double compliance);

}  // namespace halsted
