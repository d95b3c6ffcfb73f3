#pragma once
/// Thread alone that touches itself and fixed solids, in a curve that a test lays down; driven through the solve that the scene uses.
#include <cmath>
#include <functional>
#include <vector>

#include "sim/strand/strand.h"
#include "sim/strand/thread_contacts.h"

namespace halsted {

/// 3-0 braided thread: 0.25 mm wide, EA of silk (8.7 GPa, physics.md D), bending as the 2-0 default scaled by the fourth power of width.
inline SimParams knotThread(double segment = 0.3e-3) {   // [m]
  SimParams p;
  p.gravity.setZero();
  p.thread.segmentLength = segment;
  p.thread.radius = 0.125e-3;
  p.thread.axialStiffness = 430.0;
  p.thread.bendingStiffness = 1.9e-8;
  p.thread.yieldMoment = 1e-5;                 // at the strain of the default
  p.thread.knots = true;
  p.thread.damping = 20.0;
  p.needle.arcLength = 4e-3;
  p.needle.wireRadius = 0.1e-3;
  return p;
}

/// Points `segment` apart along a finely sampled curve.
inline std::vector<Vec3> evenlySpaced(const std::vector<Vec3>& fine, double segment) {   // [m]
  std::vector<Vec3> out{fine.front()};
  std::size_t i = 0;
  while (true) {
    while (i + 1 < fine.size() && (fine[i + 1] - out.back()).norm() < segment) ++i;
    if (i + 1 >= fine.size()) return out;
    // On the chord from fine[i] to fine[i + 1], the point at distance `segment` from the last one.
    const Vec3 a = fine[i] - out.back(), d = fine[i + 1] - fine[i];
    const double k = d.squaredNorm(), h = a.dot(d), c = a.squaredNorm() - segment * segment;   // [m^2]
    const double f = (-h + std::sqrt(std::fmax(h * h - k * c, 0.0))) / k;                      // [1]
    out.push_back(fine[i] + f * d);
  }
}

/// A curve given by a function of u in [0, 1], evenly spaced.
inline std::vector<Vec3> evenlySpaced(const std::function<Vec3(double)>& curve, double segment) {   // [m]
  std::vector<Vec3> fine;
  for (int i = 0; i <= 20000; ++i) fine.push_back(curve(i / 20000.0));
  return evenlySpaced(fine, segment);
}

struct KnotRig {
  StrandModel model;
  StrandState state;
  StrandWork work;
  ThreadContactState contacts;
  ThreadContactWork contactWork;
  std::vector<ThreadSolid> solids;
  std::vector<StrandLink> held;
  Vec3 gravity = Vec3::Zero();                 // [m/s^2]
  double dt = 0.25e-3;                         // [s]
  int iterations = 0;                          // of all solves

  KnotRig(SimParams p, const std::vector<Vec3>& curve, const ThreadContactParams& c = {})
      : model((p.thread.nodes = static_cast<int>(curve.size()), buildStrand(p))), state(restState(model, needlePose(model, curve))),
        work(prepareWork(model)), contacts(restContacts(model)), contactWork(prepareContactWork(model, c)) {
    state.position = curve;
  }

  static Pose needlePose(const StrandModel& m, const std::vector<Vec3>& curve) {
    Pose pose;
    const Vec3 along = (curve.back() - curve[curve.size() - 2]).normalized();
    pose.orientation = turnOnto(m.arcTangent.front(), along);
    pose.position = curve.back() - pose.orientation * m.arcPoint.front();
    return pose;
  }

  double coordinate(int node) const { return node * model.segment; }   // [m]
  std::size_t hold(int node, double stiffness) {   // [N/m]
    StrandLink link;
    link.coordinate = coordinate(node);
    link.anchor = state.position[node];
    link.stiffness = stiffness * Mat3::Identity();
    held.push_back(link);
    return held.size() - 1;
  }
  std::size_t pull(int node, const Vec3& force) {   // [N]
    StrandLink link;
    link.coordinate = coordinate(node);
    link.force0 = force;
    held.push_back(link);
    return held.size() - 1;
  }
  const Vec3& forceOf(std::size_t link) const { return work.links[link].force; }

  bool step() {
    work.linkCount = work.turnCount = 0;
    for (const StrandLink& link : held) addLink(work, link);
    contactWork.solids = solids;
    ThreadTouch touch{contacts, contactWork};
    const bool solved = solveStrand(model, dt, gravity, state, work, &touch);
    iterations += work.iterations;
    return solved;
  }
  bool run(int steps) {
    for (int k = 0; k < steps; ++k)
      if (!step()) return false;
    return true;
  }
  bool finite() const {
    for (const Vec3& x : state.position)
      if (!x.allFinite()) return false;
    return true;
  }
};

}  // namespace halsted
