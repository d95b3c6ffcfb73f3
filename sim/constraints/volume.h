#pragma once
/// Keeps the volume of a tet:  C(x) = (x1 - x0) x (x2 - x0) . (x3 - x0) / 6 - restVolume  [m^3]; signed, so an inverted tet turns back.
/// Mueller et al. 2007 (PBD); gradients in physics.md A1; compliance as in XPBD (Macklin, Mueller and Chentanez 2016, eq. 18).
#include "sim/constraints/constraint.h"

namespace halsted {

struct VolumeConstraints {                     // constant during a step
  std::vector<std::array<int, 4>> particles;   // sorted by colour, then index
  std::vector<double> restVolume;              // [m^3]
  std::vector<double> compliance;              // [m^3/Pa] rest volume / bulk modulus; 0 = rigid
};

int size(const VolumeConstraints&);
void project(const VolumeConstraints&, double h, Particles&);                              // h [s]
void project(const VolumeConstraints&, double h, Particles&, std::span<double> multiplier);     // h [s], multiplier [Pa s^2]
/// Of the compliant constraints; a rigid one stores none.  [J]
double energy(const VolumeConstraints&, const Particles&);
static_assert(Constraint<VolumeConstraints>);

/// One constraint per tet, at its present volume.  compliance [m^3/Pa]
VolumeConstraints makeVolumeConstraints(const std::vector<std::array<int, 4>>& tets, const Particles&, double compliance);

}  // namespace halsted
