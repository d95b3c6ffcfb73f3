#include "sim/strand/strand.h"
#include "sim/strand/needle_iterate.h"
#include "sim/strand/step_share.h"
#include "sim/strand/strand_trust.h"
#include "sim/strand/thread_bending.h"

#include <algorithm>

namespace halsted {
namespace {

constexpr int kMostIterations = 8;              // a calm thread takes one; a whipping one turns its segments far in a step
constexpr int kMostAttempts = 5;                // more drag each time, when thread near thread moves too far in a step
constexpr double kLengthTolerance = 2e-6;      // [m] a thousandth of a segment
constexpr double kSwageStiffness = 2e5;        // [N/m] thread end to needle: a crimp, far stiffer than anything it pulls on

/// A material point of the strand as a linear function of the unknowns: up to two thread nodes, or the needle with an arm.
struct Spot {
  int node = -1;                               // first thread node; -1: on the needle
  double weight0 = 1.0, weight1 = 0.0;         // [1]
  Vec3 arm = Vec3::Zero(), position = Vec3::Zero();   // [m] world, from the centre of mass; at the iterate
};

bool isCut(const ThreadTouch* touch, int segment) { return touch && touch->state.cut[segment]; }

class Assembly {
 public:
  Assembly(const StrandModel& m, double dt, StrandWork& w, const ThreadTouch* touch) : model_(m), dt_(dt), work_(w), touch_(touch) {}
  const StrandModel& model() const { return model_; }
  double dt() const { return dt_; }            // [s]

  Spot spotAt(double s, const NeedleIterate& needle) const {
    Spot spot;
    if (s > model_.length) {
      Vec3 point, tangent;
      arcAt(model_, s, point, tangent);
      spot.arm = needle.pose.orientation * (point - model_.needleCentre);
      spot.position = needle.centre + spot.arm;
      return spot;
    }
    const auto [node, fraction] = threadSpot(model_, s);
    spot = {node, 1.0 - fraction, fraction, Vec3::Zero(), Vec3::Zero()};
    spot.position = spot.weight0 * work_.iterate[spot.node] + spot.weight1 * work_.iterate[spot.node + 1];
    return spot;
  }

  void addBlock(int i, int j, const Mat3& k) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) work_.matrix.add(i + r, j + c, k(r, c));
  }
  void addForce(int i, const Vec3& f) {
    for (int r = 0; r < 3; ++r) work_.rhs[i + r] += f[r];
  }
  /// Force `f` and stiffness `k` at a point, into the unknowns it depends on.
  void addPoint(const Spot& spot, const Mat3& k, const Vec3& f) {
    if (spot.node >= 0) {
      const int i = 3 * spot.node;
      addBlock(i, i, spot.weight0 * spot.weight0 * k);
      addBlock(i, i + 3, spot.weight0 * spot.weight1 * k);
      addBlock(i + 3, i + 3, spot.weight1 * spot.weight1 * k);
      addForce(i, spot.weight0 * f);
      addForce(i + 3, spot.weight1 * f);
      return;
    }
    const int p = needleIndex();
    const Mat3 lever = skew(spot.arm);
    addBlock(p, p, k);
    addBlock(p, p + 3, -k * lever);
    addBlock(p + 3, p + 3, lever.transpose() * k * lever);
    addForce(p, f);
    addForce(p + 3, spot.arm.cross(f));
  }
  int needleIndex() const { return 3 * model_.nodes; }

  void inertia(const StrandState& s, const Vec3& gravity, const NeedleIterate& needle) {
    const double stiff = 1.0 / (dt_ * dt_), drag = model_.damping / dt_;
    for (int i = 0; i < model_.nodes; ++i) {
      const double m = model_.mass[i];
      for (int c = 0; c < 3; ++c) work_.matrix.add(3 * i + c, 3 * i + c, m * (stiff + drag));
      addForce(3 * i, m * (gravity - stiff * (work_.iterate[i] - work_.inertial[i]) - drag * (work_.iterate[i] - s.position[i])));
    }
    const int p = needleIndex();
    const double m = model_.needleMass;
    const Vec3 startCentre = s.needle.apply(model_.needleCentre);   // [m]
    addBlock(p, p, m * (stiff + drag) * Mat3::Identity());
    addForce(p, m * (gravity - stiff * (needle.centre - needle.inertialCentre) - drag * (needle.centre - startCentre)));
    addBlock(p + 3, p + 3, (stiff + drag) * needle.inertia);
    const Vec3 lag = rotationBetween(needle.inertial.orientation, needle.pose.orientation);
    const Vec3 moved = rotationBetween(s.needle.orientation, needle.pose.orientation);
    addForce(p + 3, -needle.inertia * (stiff * lag + drag * moved));
  }

  /// The geometric stiffness takes the tension of the last linear solve, not that of the iterate: extrapolated rotation stretches every
  /// segment, and the hundreds of newtons that it seems to carry would hold the thread on its inertial path against its own bending.
  void stretch(const StrandState& s) {
    for (int i = 0; i + 1 < model_.nodes; ++i) {
      const Vec3 d = work_.iterate[i + 1] - work_.iterate[i];
      const double length = d.norm();
      if (!(length > 1e-9) || isCut(touch_, i)) continue;
      const Vec3 t = d / length;
      const double axial = model_.axialOf[i], force = axial * (length - model_.rest[i]);   // [N/m], [N]
      Mat3 k = axial * t * t.transpose();
      if (s.tension[i] > 0.0) k += (s.tension[i] / length) * (Mat3::Identity() - t * t.transpose());
      addBlock(3 * i, 3 * i, k);
      addBlock(3 * i, 3 * i + 3, -k);
      addBlock(3 * i + 3, 3 * i + 3, k);
      addForce(3 * i, force * t);
      addForce(3 * i + 3, -force * t);
    }
  }

  void bending() {
    BendingState state;
    if (touch_) state = {touch_->state.set, touch_->state.cut};
    assembleBending(model_, work_.iterate, state, work_.matrix, work_.rhs);
  }

  /// The crimp: last thread node on the needle's swage, and the thread leaving along the needle's tangent.
  void swage(const NeedleIterate& needle) {
    const int last = model_.nodes - 1, p = needleIndex();
    const Mat3 k = kSwageStiffness * Mat3::Identity();
    const Vec3 arm = needle.pose.orientation * (model_.arcPoint.front() - model_.needleCentre);
    const Vec3 gap = needle.centre + arm - work_.iterate[last];
    addBlock(3 * last, 3 * last, k);
    addForce(3 * last, kSwageStiffness * gap);
    addPoint({-1, 1.0, 0.0, arm, Vec3::Zero()}, k, -kSwageStiffness * gap);
    addBlock(3 * last, p, -k);
    addBlock(3 * last, p + 3, k * skew(arm));

    const Vec3 ahead = arm + model_.rest.back() * (needle.pose.orientation * model_.arcTangent.front());
    const Vec3 curl = work_.iterate[last - 1] - 2.0 * work_.iterate[last] + needle.centre + ahead;
    const double kb = 2.0 * model_.bend.back().stiffness, c[2] = {1.0, -2.0};   // the crimp is a clamp: half a segment of thread bends there
    for (int a = 0; a < 2; ++a) {
      const int i = 3 * (last - 1 + a);
      addBlock(i, i, kb * c[a] * c[a] * Mat3::Identity());
      addForce(i, -kb * c[a] * curl);
      addBlock(i, p, kb * c[a] * Mat3::Identity());
      addBlock(i, p + 3, -kb * c[a] * skew(ahead));
    }
    addBlock(3 * (last - 1), 3 * last, -2.0 * kb * Mat3::Identity());
    addPoint({-1, 1.0, 0.0, ahead, Vec3::Zero()}, kb * Mat3::Identity(), -kb * curl);
  }

  void links(const NeedleIterate& needle) {
    for (int l = 0; l < work_.linkCount; ++l) {
      const StrandLink& link = work_.links[l];
      const Spot spot = spotAt(link.coordinate, needle);
      addPoint(spot, link.stiffness, link.force0 + link.stiffness * (link.anchor - spot.position));
    }
    for (int t = 0; t < work_.turnCount; ++t) {
      const NeedleTurnLink& turn = work_.turns[t];
      const int p = needleIndex() + 3;
      addBlock(p, p, turn.stiffness * Mat3::Identity());
      addForce(p, turn.stiffness * rotationBetween(needle.pose.orientation, turn.target));
    }
  }

 private:
  const StrandModel& model_;
  double dt_;                                  // [s]
  StrandWork& work_;
  const ThreadTouch* touch_;                   // or null
};

/// Tension consistent with the linear solve: the stretch along the direction the segment had in the last iterate.
void writeTensions(const StrandModel& m, const StrandWork& w, const ThreadTouch* touch, StrandState& s) {
  for (int i = 0; i + 1 < m.nodes; ++i) {
    const Vec3 d = w.iterate[i + 1] - w.iterate[i];
    const double length = d.norm();
    const Vec3 moved(w.rhs[3 * i + 3] - w.rhs[3 * i], w.rhs[3 * i + 4] - w.rhs[3 * i + 1], w.rhs[3 * i + 5] - w.rhs[3 * i + 2]);
    const double along = length > 1e-9 ? d.dot(moved) / length : 0.0;
    s.tension[i] = isCut(touch, i) ? 0.0 : m.axialOf[i] * (length + along - m.rest[i]);
  }
}

/// How far a segment is from the length that its tension in the linear solve says: what turning segments leave over [m].
double lengthError(const StrandModel& m, const StrandWork& w, const ThreadTouch* touch, const StrandState& s) {
  double worst = 0.0;
  for (int i = 0; i + 1 < m.nodes; ++i) {
    if (isCut(touch, i)) continue;
    const double error = (w.iterate[i + 1] - w.iterate[i]).norm() - m.rest[i] - s.tension[i] / m.axialOf[i];
    worst = std::max(worst, error < 0.0 ? -error : error);
  }
  return worst;
}

void finish(const StrandModel& m, double dt, const NeedleIterate& n, StrandState& s, StrandWork& w) {
  for (int i = 0; i < m.nodes; ++i) {
    s.velocity[i] = (w.iterate[i] - s.position[i]) / dt;
    s.position[i] = w.iterate[i];
  }
  s.needleVelocity = (n.centre - s.needle.apply(m.needleCentre)) / dt;
  s.needleSpin = rotationBetween(s.needle.orientation, n.pose.orientation) / dt;
  s.needle = n.pose;
  for (int l = 0; l < w.linkCount; ++l) {
    StrandLink& link = w.links[l];
    link.force = link.force0 + link.stiffness * (link.anchor - strandPoint(m, s, link.coordinate));
  }
}

bool solveSystem(StrandWork& w, ThreadTouch* touch) {
  if (!touch) return w.matrix.factorAndSolve(w.rhs.data());
  ThreadContactWork& t = touch->work;
  if (!(t.coupledStep ? t.coupled.solve(w.matrix, w.rhs.data()) : w.matrix.factorAndSolve(w.rhs.data()))) return false;
  readHands(w.rhs, t.coupled, t.hands);
  return true;
}

enum class Outcome { kSingular, kUnsettled, kSettled };
/// Newton's iteration from the path of inertia, with more drag on the thread than its own if the contacts ask for it.
Outcome iterate(Assembly& assembly, const Vec3& gravity, StrandState& s, NeedleIterate& needle, StrandWork& w, ThreadTouch* touch) {
  const StrandModel& m = assembly.model();
  const double tolerance = std::min(kLengthTolerance, 1e-3 * m.finest);   // [m]
  w.iterate = w.inertial;
  if (touch) beginHands(touch->work.hands);
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    ++w.iterations;
    w.matrix.setZero();
    std::fill(w.rhs.begin(), w.rhs.end(), 0.0);
    assembly.inertia(s, gravity, needle);
    assembly.stretch(s);
    assembly.bending();
    assembly.swage(needle);
    assembly.links(needle);
    if (touch) {
      assembleSnapDrag(m, s, assembly.dt(), *touch, w);
      assembleThreadContacts(w.iterate, w.matrix, w.rhs, touch->work);
    }
    if (touch) w.load = w.rhs;
    if (!solveSystem(w, touch)) return Outcome::kSingular;
    const bool moving = touch && stillMoving(m, w.rhs, touch->work);
    if (touch) takeCorrection(w, touch->work);
    writeTensions(m, w, touch, s);
    for (int i = 0; i < m.nodes; ++i) w.iterate[i] += Vec3(w.rhs[3 * i], w.rhs[3 * i + 1], w.rhs[3 * i + 2]);
    moveNeedle(m, &w.rhs[3 * m.nodes], needle);
    if (lengthError(m, w, touch, s) < tolerance && !moving) return Outcome::kSettled;
  }
  return Outcome::kUnsettled;
}

}  // namespace

bool solveStrand(const StrandModel& m, double dt, const Vec3& gravity, StrandState& s, StrandWork& w, ThreadTouch* touch) {
  w.iterations = 0;
  for (int i = 0; i < m.nodes; ++i) w.inertial[i] = s.position[i] + dt * s.velocity[i];
  if (touch) beginTouch(m, s, dt, *touch);
  for (int attempt = 0;; ++attempt) {
    NeedleIterate needle = beginNeedle(m, s, dt);
    Assembly assembly(m, dt, w, touch);
    const Outcome outcome = iterate(assembly, gravity, s, needle, w, touch);
    if (outcome == Outcome::kSingular) return false;
    if (touch && attempt < kMostAttempts && mustSlow(m, s, w, outcome == Outcome::kSettled, *touch)) continue;
    w.settled = outcome == Outcome::kSettled;
    if (m.takesSet && touch) takeSet(m, s.position, w.iterate, touch->state.set);
    finish(m, dt, needle, s, w);
    if (touch) settleThreadContacts(s, *touch);
    return true;
  }
}

}  // namespace halsted
