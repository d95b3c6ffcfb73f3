#pragma once
/// What the substepping solvers share: symplectic Euler before the constraints, velocity from the motion after them.
#include <span>

#include "sim/tissue/tissue.h"

namespace halsted {

/// v damped, v += h a (in this order, or damping would take weight off a tissue at rest), rows := (x + h v, inverse mass).
/// `work.target` keeps where the substep began.  h [s]
inline void beginSubstep(const TissueModel& m, std::span<const Vec3> force, double h, TissueState& s, TissueWork& w) {
  const double damping = 1.0 / (1.0 + h * m.massDamping);              // [1] implicit, never overshoots
  for (std::size_t i = 0; i < m.mass.size(); ++i) {
    double* row = &w.rows[4 * i];              // [m] x, y, z and [1/kg]
    w.target[i] = s.position[i];
    Vec3 moved = s.position[i];
    const double inverseMass = m.isFixed[i] ? 0.0 : 1.0 / m.mass[i];   // [1/kg]
    const Vec3 weight = s.left.empty() ? m.gravity : Vec3(s.left[i] * m.gravity);   // [m/s^2]
    if (!m.isFixed[i]) moved += h * (damping * s.velocity[i] + h * (weight + inverseMass * force[i]));
    row[0] = moved.x(); row[1] = moved.y(); row[2] = moved.z(); row[3] = inverseMass;
  }
}

inline void endSubstep(double h, TissueState& s, TissueWork& w) {      // h [s]
  const double rate = 1.0 / h;                                         // [1/s]
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    const Vec3 x(w.rows[4 * i], w.rows[4 * i + 1], w.rows[4 * i + 2]);
    s.velocity[i] = rate * (x - w.target[i]);
    s.position[i] = x;
  }
}

/// Sets `previous` so that finishTissue gives the velocity at the end of the last substep, not the mean over the step, which lags
/// half a step behind and would lose almost half of gravity.
inline void endSubsteps(const TissueModel& m, const TissueState& s, TissueWork& w) {
  for (std::size_t i = 0; i < s.position.size(); ++i) w.previous[i] = s.position[i] - m.dt * s.velocity[i];
}

}  // namespace halsted
