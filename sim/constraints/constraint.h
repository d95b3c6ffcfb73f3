#pragma once
/// Positional constraints in the manner of XPBD (Macklin, Mueller and Chentanez 2016): a constraint is arrays that a step never
/// changes, and three plain functions. No base class, no virtual call, no registry: callers name each set, in the order they want.
/// A sweep goes by colour, then index (colour_order.h): projections of a colour overlap in the processor instead of waiting for each other.
/// No scene uses these two sets: they are measured against the solvers of sim/tissue in tests/bench and held to their laws in tests/sim.
#include <concepts>
#include <span>
#include <vector>

#include "sim/constraints/colour_order.h"
#include "sim/types.h"

namespace halsted {

/// A row of 32 bytes: what a projection reads and writes of a particle lies in one half of a cache line.
struct Particle {
  Vec3 position = Vec3::Zero();                // [m]
  double inverseMass = 1.0;                    // [1/kg] 0: held in place
};
static_assert(sizeof(Particle) == 32);
using Particles = std::vector<Particle>;

/// project: one Gauss-Seidel sweep in index order. Without multipliers it is the only sweep of its substep (Macklin et al. 2019, one
/// iteration a substep); with `multiplier`, one per constraint and zero at the start of the substep, any number of sweeps converges
/// to the same answer.  h [s], multiplier: [N s^2] times the unit of 1/gradient
template <class C>
concept Constraint = requires(const C& set, double h, Particles& particles, const Particles& still, std::span<double> multiplier) {
  { size(set) } -> std::convertible_to<int>;
  project(set, h, particles);
  project(set, h, particles, multiplier);
  { energy(set, still) } -> std::convertible_to<double>;
};

}  // namespace halsted
