#pragma once
/// Thread and needle alone, held by stiff springs, driven through the solve that the scene uses; and their mechanical energy.
#include <vector>

#include "sim/strand/strand.h"

namespace halsted {

/// A thread of `length` in `nodes` nodes, undamped and weightless unless a test says otherwise.
inline SimParams threadParams(int nodes, double length) {   // length [m]
  SimParams p;
  p.gravity.setZero();
  p.thread.nodes = nodes;
  p.thread.segmentLength = length / (nodes - 1);
  p.thread.damping = 0.0;
  return p;
}

struct StrandRig {
  static constexpr double kHold = 1e5;         // [N/m] far stiffer than the thread's bending and its weight
  StrandModel model;
  StrandState state;
  StrandWork work;
  Vec3 gravity;                                // [m/s^2]
  double dt = 1e-3;                            // [s]
  std::vector<StrandLink> held;

  /// Needle at the origin; the thread leaves the swage straight along -y.
  explicit StrandRig(const SimParams& p) : model(buildStrand(p)), state(restState(model, Pose{})), work(prepareWork(model)), gravity(p.gravity) {}

  /// Holds a material point where it is now; returns the link's index.
  std::size_t hold(double coordinate, const Mat3& stiffness = kHold * Mat3::Identity()) {   // coordinate [m], stiffness [N/m]
    StrandLink link;
    link.coordinate = coordinate;
    link.anchor = strandPoint(model, state, coordinate);
    link.stiffness = stiffness;
    held.push_back(link);
    return held.size() - 1;
  }
  void pull(double coordinate, const Vec3& force) {   // coordinate [m], force [N]
    StrandLink link;
    link.coordinate = coordinate;
    link.force0 = force;
    held.push_back(link);
  }
  void clampNeedle() {
    const double arc = tipCoordinate(model) - model.length;   // [m]
    for (double share : {1e-6, 0.5, 1.0}) hold(model.length + share * arc);
  }

  bool step() {
    work.linkCount = work.turnCount = 0;
    for (const StrandLink& link : held) addLink(work, link);
    return solveStrand(model, dt, gravity, state, work);
  }
  bool run(int steps) {
    for (int k = 0; k < steps; ++k)
      if (!step()) return false;
    return true;
  }

  /// Lays the thread along a straight line that ends at the swage; `away` [1] points from the swage to the tail.
  void layStraight(const Vec3& away) {
    const Vec3 swage = state.needle.apply(model.arcPoint.front());
    for (int i = 0; i < model.nodes; ++i) state.position[i] = swage + (model.nodes - 1 - i) * model.segment * away;
  }

  double length() const {                      // [m]
    double sum = 0.0;                          // [m]
    for (int i = 0; i + 1 < model.nodes; ++i) sum += (state.position[i + 1] - state.position[i]).norm();
    return sum;
  }
  Vec3 momentum() const {                      // [kg m/s]
    Vec3 sum = model.needleMass * state.needleVelocity;
    for (int i = 0; i < model.nodes; ++i) sum += model.mass[i] * state.velocity[i];
    return sum;
  }
  double fastest() const {                     // [m/s]
    double most = state.needleVelocity.norm();                 // [m/s]
    for (const Vec3& v : state.velocity) most = std::max(most, v.norm());
    return most;
  }
  bool finite() const {
    for (int i = 0; i < model.nodes; ++i)
      if (!state.position[i].allFinite() || !state.velocity[i].allFinite()) return false;
    return state.needle.position.allFinite() && state.needle.orientation.coeffs().allFinite();
  }

  double kinetic() const {                     // [J]
    const Mat3 r = state.needle.orientation.toRotationMatrix();
    double sum = 0.5 * model.needleMass * state.needleVelocity.squaredNorm();   // [J]
    sum += 0.5 * state.needleSpin.dot(r * model.needleInertia * r.transpose() * state.needleSpin);
    for (int i = 0; i < model.nodes; ++i) sum += 0.5 * model.mass[i] * state.velocity[i].squaredNorm();
    return sum;
  }
  double weight() const {                      // [J] potential energy of gravity
    double sum = -model.needleMass * gravity.dot(state.needle.apply(model.needleCentre));   // [J]
    for (int i = 0; i < model.nodes; ++i) sum -= model.mass[i] * gravity.dot(state.position[i]);
    return sum;
  }
  /// Stretch, bending (with the hinge at the swage) and the springs that hold; the crimp's own 1e-7 J are left out. Stretch is that of the
  /// tension which the solve carries: the length of a turning segment is only known to a thousandth.
  double elastic() const {                     // [J]
    double sum = 0.0;                          // [J]
    const auto& x = state.position;
    for (std::size_t i = 0; i < state.tension.size(); ++i) sum += 0.5 * state.tension[i] * state.tension[i] / model.axialOf[i];
    for (int i = 0; i + 2 < model.nodes; ++i) {
      const NodeBend& b = model.bend[i];
      sum += 0.5 * b.stiffness * (b.weight[0] * x[i] + b.weight[1] * x[i + 1] + b.weight[2] * x[i + 2]).squaredNorm();
    }
    const Vec3 ahead = state.needle.apply(model.arcPoint.front() + model.segment * model.arcTangent.front());
    sum += 0.5 * model.bend.back().stiffness * (x[model.nodes - 2] - 2.0 * x[model.nodes - 1] + ahead).squaredNorm();
    for (const StrandLink& link : held) {
      const Vec3 gap = link.anchor - strandPoint(model, state, link.coordinate);
      sum += 0.5 * gap.dot(link.stiffness * gap) - link.force0.dot(strandPoint(model, state, link.coordinate));
    }
    return sum;
  }
  double energy() const { return kinetic() + weight() + elastic(); }   // [J]
};

}  // namespace halsted
