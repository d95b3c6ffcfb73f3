#pragma once
/// The springback of a punctured surface by shape matching (acupuncture-force-net 2021, section 3.3, eqs. 7 to 9; Mueller et al. 2005),
/// corrected as physics.md A3 f says: the rotation comes from the ring that supports the dimple, because the whole tissue's is the
/// identity; the factor falls at a rate, so that it means the same at every step; and what friction holds does not spring back.
#include <span>

#include "sim/types.h"

namespace halsted {

/// The rotation of A = R S, by Higham's iteration (1986): + - * / only. The identity when A is singular.
Mat3 rotationOf(const Mat3&);

/// Eqs. 7 and 8: the rigid motion that carries `rest` [m], a closed ring, best onto `now` [m]:  goal = rotation * p0 + shift.
struct Match {
  Mat3 rotation = Mat3::Identity();
  Vec3 shift = Vec3::Zero();                   // [m]
  Vec3 goal(const Vec3& rest) const { return rotation * rest + shift; }
};
Match matchRing(std::span<const Vec3> rest, std::span<const Vec3> now);

/// What remains of a springback after `time` of `whole`: 1 falls to 0 and lands without speed.  time, whole [s]
double springbackRemaining(double time, double whole);

/// Eq. 9 with the factor `factor` [1]: p = g + factor (p - g). The ratio of two values of springbackRemaining makes it a rate: any
/// number of steps ends at the same place. The paper's own eta, taken off by eta_r each step, is the same function with factor = eta.
inline Vec3 springBack(const Vec3& goal, double factor, const Vec3& p) { return goal + factor * (p - goal); }   // factor [1]

}  // namespace halsted
