#include "sim/suture/knotting.h"

#include <algorithm>
#include <cmath>

#include "sim/suture/holes.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kJawReach = 4e-3;             // [m] of thread on either side of the grip that the jaws do not push away

/// What a grip is at the start of the step and at its end.
struct GripPath {
  int link = -1;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();   // [m]
};

/// The grip's anchor at the start: it pulled with `pull` on the tool when the last step ended.
GripPath gripFrom(const Model& m, const State& s, int link, const Vec3& pull) {   // [N]
  if (link < 0) return {};
  const StrandLink& l = s.work.strand.links[link];
  return {link, strandPoint(m.strand, s.strand, l.coordinate) - pull / l.stiffness(0, 0), l.anchor};
}

Quat between(const Quat& a, const Quat& b, double share) {   // [1]
  const double sign = a.dot(b) < 0.0 ? -1.0 : 1.0;           // [1]
  Quat q;
  q.coeffs() = (1.0 - share) * a.coeffs() + share * sign * b.coeffs();
  return q.normalized();
}

/// Of what presses on a tool, the thread's part: the rest is the needle's.  [N]
Vec3 threadPush(const Model& m, const State& s, int hand) {
  Vec3 push = s.tools[hand].strandForce;
  const int triangles = static_cast<int>(m.surface.triangles.size());
  for (int i = 0; i < s.strand.contactCount; ++i) {
    const StrandContact& c = s.strand.contacts[i];
    if (c.feature >= triangles && solidHand(c.feature - triangles) == hand) push += c.force;
  }
  return push;
}

class Substeps {
 public:
  Substeps(const Model& m, const KnottingMotion& motion, State& s) : model_(m), motion_(motion), state_(s) {
    for (int hand = 0; hand < kHands; ++hand) {
      const ToolState& t = s.tools[hand];
      needle_[hand] = gripFrom(m, s, motion.grasps[hand].needle, t.needleForce);
      thread_[hand] = gripFrom(m, s, motion.grasps[hand].thread, t.threadForce);
      const double spring = m.params.tools[hand].couplingStiffness;   // [N/m]
      offset_[hand] = threadPush(m, s, hand) / spring;
      s.work.threadContacts.hands.tool[hand] = {spring, offset_[hand], Vec3::Zero()};
    }
    for (int turn = 0; turn < s.work.strand.turnCount; ++turn) turnTo_[turn] = s.work.strand.turns[turn].target;
  }

  void place(double before, double now) {      // [1] of the step
    StrandWork& w = state_.work.strand;
    int turn = 0;
    for (int hand = 0; hand < kHands; ++hand) {
      for (const GripPath* path : {&needle_[hand], &thread_[hand]})
        if (path->link >= 0) w.links[path->link].anchor = path->from + now * (path->to - path->from);
      if (needle_[hand].link < 0) continue;
      const Quat from = (motion_.toolBefore[hand].orientation * state_.tools[hand].needleInTool.orientation).normalized();
      w.turns[turn].target = between(from, turnTo_[turn], now);
      ++turn;
    }
    for (int k = 0; k < kSolids; ++k) state_.work.threadSolids[k] = solidAt(k, before, now);
  }

 private:
  ThreadSolid solidAt(int k, double before, double now) const {   // [1] of the step
    const CapsuleShape &from = motion_.solids.before[k], &to = motion_.solids.now[k];
    ThreadSolid solid;
    solid.a = from.a + now * (to.a - from.a);
    solid.b = from.b + now * (to.b - from.b);
    solid.fromA = from.a + before * (to.a - from.a);
    solid.fromB = from.b + before * (to.b - from.b);
    solid.radius = to.radius;
    solid.friction = model_.params.contact.threadToolFriction;
    const int hand = solidHand(k);
    solid.owner = hand;
    if (hand >= 0) moveSolid(state_.work.threadContacts.hands.tool[hand].offset - offset_[hand], solid);
    if (hand >= 0 && state_.tools[hand].through) {               // it would take thread along through the wall
      solid.freeFrom = 0.0;
      solid.freeTo = tipCoordinate(model_.strand);
      return solid;
    }
    const double held = hand >= 0 ? state_.tools[hand].threadCoordinate : -1.0;   // [m]
    if (hand >= 0 && k % kSolidsPerTool < 2 && state_.tools[hand].holdsNeedle) {   // closed on it: its thread between the jaws is not crushed
      solid.freeFrom = needlePieceFrom(model_, state_);
      solid.freeTo = model_.strand.length;
    } else if (held >= 0.0) {
      solid.freeFrom = held - kJawReach;
      solid.freeTo = held + kJawReach;
    }
    return solid;
  }

  /// Where the piece of the thread begins that hangs on the needle.  [m]
  static double needlePieceFrom(const Model& m, const State& s) {
    int i = m.strand.nodes - 1;
    while (i > 0 && !s.threadContacts.cut[i - 1]) --i;
    return m.strand.place[i];
  }

  static void moveSolid(const Vec3& by, ThreadSolid& solid) {   // [m]
    for (Vec3* p : {&solid.a, &solid.b, &solid.fromA, &solid.fromB}) *p += by;
  }

  const Model& model_;
  const KnottingMotion& motion_;
  State& state_;
  std::array<Vec3, kHands> offset_;            // [m] by which thread had pushed the tools when the step began
  std::array<GripPath, kHands> needle_, thread_;
  std::array<Quat, kHands> turnTo_;
};

/// A pull that breaks thread lasts the whole step, solved to its end: what stops an end that whips is over within a substep.
bool staysOverloaded(const Model& m, const State& s, int segment) {
  return segment >= 0 && s.work.strand.settled && s.strand.tension[segment] >= m.params.thread.breakingTension;
}

void breakThread(State& s, int segment, StepOutput& out) {
  s.threadContacts.cut[segment] = 1;
  pushEvent(out, {s.step, EventKind::kThreadBroken, -1, segment, s.strand.tension[segment]});
  s.strand.tension[segment] = 0.0;
}

/// More of them where a tool jumps, as one that springs back from what held it: thread must not find itself deep in a tool.
int substepsFor(const Model& m, const SolidMotion& solids) {
  constexpr double kMostWay = 0.5e-3;          // [m] of a tool in a substep: a few times as wide as thread
  constexpr int kMost = 4;                     // [1] times as many
  double way = 0.0;                            // [m]
  for (int k = 0; k < kSolids; ++k) way = std::max({way, (solids.now[k].a - solids.before[k].a).norm(), (solids.now[k].b - solids.before[k].b).norm()});
  const int count = m.params.thread.substeps;
  return count * std::clamp(static_cast<int>(std::ceil(way / (count * kMostWay))), 1, kMost);
}

}  // namespace

bool solveKnottedStrand(const Model& m, const KnottingMotion& motion, State& s, StepOutput& out) {
  const int count = substepsFor(m, motion.solids);
  Substeps substeps(m, motion, s);
  ThreadTouch touch{s.threadContacts, s.work.threadContacts};
  touch.work.solids = s.work.threadSolids;
  int worst = -1;
  for (int k = 0; k < count; ++k) {
    substeps.place(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
    if (!solveStrand(m.strand, m.params.dt / count, m.params.gravity, s.strand, s.work.strand, &touch)) return false;
    if (k == 0) worst = overloadedSegment(s.strand, m.params.thread.breakingTension);
    if (!staysOverloaded(m, s, worst)) worst = -1;
  }
  if (worst >= 0) breakThread(s, worst, out);
  return true;
}

void settleToolForces(State& s) {
  for (int hand = 0; hand < kHands; ++hand) {
    const GivingTool& t = s.work.threadContacts.hands.tool[hand];
    s.tools[hand].strandForce += t.spring * t.offset;
  }
}

bool partedAt(const Model& m, const State& s, double coordinate) {
  if (s.threadContacts.cut.empty() || coordinate > m.strand.length) return false;
  return s.threadContacts.cut[threadSpot(m.strand, coordinate).node] != 0;
}

double threadEnd(const Model& m, const State& s, double coordinate) {
  if (s.threadContacts.cut.empty() || coordinate > m.strand.length) return m.strand.length;
  for (int i = threadSpot(m.strand, coordinate).node; i + 1 < m.strand.nodes; ++i)
    if (s.threadContacts.cut[i]) return m.strand.place[i];
  return m.strand.length;
}

}  // namespace halsted
