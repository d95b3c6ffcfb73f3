#pragma once
/// The needle, a rigid body, in the strand's Newton iteration: six unknowns behind those of the thread's nodes. Pure functions.
#include "sim/strand/strand_model.h"
#include "sim/strand/strand_state.h"

namespace halsted {

/// The needle while iterating: pose of this iterate, and where inertia alone would take it.
struct NeedleIterate {
  Pose pose, inertial;
  Vec3 centre = Vec3::Zero(), inertialCentre = Vec3::Zero();   // [m] centre of mass
  Mat3 inertia = Mat3::Zero();                                 // [kg m^2] world
};

inline Mat3 skew(const Vec3& v) {
  Mat3 s;
  s << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return s;
}

inline Quat turned(const Quat& q, const Vec3& angle) {   // [rad], small
  const Quat dq(1.0, 0.5 * angle.x(), 0.5 * angle.y(), 0.5 * angle.z());
  return (dq * q).normalized();
}

/// Twice the vector part of the rotation from `from` to `to`: the rotation vector for small angles.  [rad]
inline Vec3 rotationBetween(const Quat& from, const Quat& to) {
  const Quat d = to * from.conjugate();
  const Vec3 v(d.x(), d.y(), d.z());
  return d.w() < 0.0 ? Vec3(-2.0 * v) : Vec3(2.0 * v);
}

/// Where inertia takes it in a step.
inline NeedleIterate beginNeedle(const StrandModel& m, const StrandState& s, double dt) {   // [s]
  NeedleIterate n;
  n.centre = n.inertialCentre = s.needle.apply(m.needleCentre) + dt * s.needleVelocity;
  n.pose.orientation = n.inertial.orientation = turned(s.needle.orientation, dt * s.needleSpin);
  const Mat3 r = n.pose.orientation.toRotationMatrix();
  n.inertia = r * m.needleInertia * r.transpose();
  return n;
}

/// By a correction of its six unknowns: of the centre of mass [m], of the rotation [rad].
inline void moveNeedle(const StrandModel& m, const double* u, NeedleIterate& n) {
  n.centre += Vec3(u[0], u[1], u[2]);
  n.pose.orientation = turned(n.pose.orientation, Vec3(u[3], u[4], u[5]));
  n.pose.position = n.centre - n.pose.orientation * m.needleCentre;
}

}  // namespace halsted
