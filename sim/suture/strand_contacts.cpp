#include "sim/suture/strand_contacts.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/geometry.h"
#include "sim/suture/exchange.h"
#include "sim/suture/holes.h"
#include "sim/suture/pierced_wall.h"
#include "sim/suture/strand_sample.h"
#include "sim/tools/tool_shape.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kTissueShare = 3.0;           // [1] over-estimates the compliance for neighbours that press on the same tissue
constexpr double kNodeSpacing = 2e-3;          // [m] of the thread's nodes for which that holds
constexpr double kSolidStiffness = 800.0;      // [N/m] strand against steel, per step and incremental: the fixed point is rigid
constexpr double kStickSlide = 2e-7;           // [m] per step: below it friction holds (0.2 mm/s of creep)
constexpr double kWedged = 0.3e-3;             // [m] below an edge: so far thread has cut in
constexpr double kCoarse = 1.5e-3;             // [m] nodes that lie closer cannot pass a wall on both sides
constexpr double kAbout = 1e-3;                // [m] from a solid within which a sample may come to touch it

/// What the tissue gives under one sample while its neighbours, and the holes, push too.  [m/N]
double giveOfTissue(const Model& m, const StrandSample& x, const SurfacePoint& near, State& state) {
  const double crowd = x.thread ? std::fmax(1.0, kNodeSpacing / segmentAt(m.strand, x.coordinate)) : 1.0;   // [1] where nodes lie closer, more of them press on the same tissue
  const double own = surfaceCompliance(m, {near.triangle, near.weight}, {near.triangle, near.weight}), guess = crowd * kTissueShare * own;   // [m/N]
  if (!sumsExchange(m, state)) return guess;
  const int vertex = vertexOf(m, near.triangle, near.weight);
  return std::fmax(guess, own + movedByContacts(m, vertex, state.work.exchange) + movedByHoles(m, vertex, state.work.exchange));
}

/// One unilateral contact before the solve.
struct Touch {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();   // [m] surface point now; [1] toward the strand
  Vec3 moved = Vec3::Zero();                           // [m] motion of the surface point in this step
  double stiffness = 0.0;                              // [N/m]
  StrandContact record;
};

Touch touchAt(const Model& m, const SurfacePoint& near, const Vec3& normal, const State& s) {   // [1]
  Touch t;
  t.point = near.point;
  t.normal = normal;
  t.moved = near.point - pointOn(m.surface, s.work.tissue.previous, near.triangle, near.weight);
  return t;
}

double stiffnessOn(const Model& m, const StrandSample& x, const SurfacePoint& near, State& s) { return 1.0 / (giveOfTissue(m, x, near, s) + 1e-5); }   // [N/m]

const StrandContact* previousContact(const StrandState& s, int sample, int feature, bool sameSurface, int triangles) {
  for (int i = 0; i < s.contactCount; ++i) {
    const StrandContact& c = s.contacts[i];
    if (c.sample != sample) continue;
    if (c.feature == feature || (sameSurface && c.feature < triangles)) return &c;
  }
  return nullptr;
}

/// Friction of one contact as a linear spring against the slide of this step, from a force carried over.
struct Friction {
  double stiffness = 0.0;                      // [N/m]
  Vec3 carried = Vec3::Zero();                 // [N] tangential
};

/// The thread weighs next to nothing: Coulomb's law as a lagged secant holds it. The needle is as stiff as the hand that holds it:
/// its friction is carried from step to step and grows while it sticks, so that the tissue follows (limited after the solve). So is that
/// of thread that can be knotted: drawn tight on the tissue it is as stiff as wire, and the secant would shake the wall.
Friction frictionOf(const Model& m, const StrandSample& x, const Touch& touch, double push) {
  const double held = touch.record.normalForce > 0.0 ? touch.record.normalForce : push;
  if (m.params.thread.knots || !x.thread) {
    const Vec3& old = touch.record.force;
    return {touch.stiffness, old - old.dot(touch.normal) * touch.normal};
  }
  const Vec3 slide = x.predicted - x.position - touch.moved;
  const double tangential = (slide - slide.dot(touch.normal) * touch.normal).norm();   // [m]
  return {contactFriction(m, touch.record) * held / std::fmax(tangential, kStickSlide), Vec3::Zero()};
}

/// Thread weighs next to nothing: the push that takes it out of a solid would by its inertia carry it on, and drawn thread left and came back
/// every other step (0.9 m/s over the rod). What pushed in the last step is solved for once more; the solve tells whether it still pushes.
/// Not yet where thread is knotted and nothing can be cut: the scripts of those scenes are tuned without.
bool staysForAStep(const Model& m, const State& s, const Touch& touch) { return (!m.params.thread.knots || s.cut) && touch.record.normalForce > 0.0; }

/// Adds the link if the contact would push; keeps its record in `fresh`.
void offerTouch(const Model& m, const StrandSample& x, Touch& touch, State& state, int& fresh) {
  StrandWork& w = state.work.strand;
  const double gap = touch.normal.dot(x.predicted - touch.point) - x.radius;     // [m]
  const double push = touch.record.normalForce - touch.stiffness * gap;          // [N] at the predicted position
  if ((push <= 0.0 && !staysForAStep(m, state, touch)) || fresh >= StrandState::kMaxContacts) return;
  const Mat3 nn = touch.normal * touch.normal.transpose();
  const Friction grip = frictionOf(m, x, touch, push);
  StrandLink link;
  link.coordinate = x.thread ? x.coordinate : x.coordinate + 1e-12;
  link.stiffness = touch.stiffness * nn + grip.stiffness * (Mat3::Identity() - nn);
  const Vec3 onSurface = touch.point + x.radius * touch.normal, stuck = x.position + touch.moved;
  link.anchor = stuck + nn * (onSurface - stuck);
  link.force0 = touch.record.normalForce * touch.normal + grip.carried;
  if (!addLink(w, link)) return;
  touch.record.force = touch.normal;           // until the solve: the direction
  state.work.freshLink[fresh] = w.linkCount - 1;
  state.work.freshContacts[fresh++] = touch.record;
}

/// Does the thread end here: its tail, or where it is cut?
bool isEnd(const Model& m, const State& s, int sample) {
  if (sample == 0 || sample >= m.strand.nodes) return sample == 0;
  return s.threadContacts.cut[sample - 1] != 0 || (sample + 1 < m.strand.nodes && s.threadContacts.cut[sample] != 0);
}

/// Does it meet the wall end on?
bool endOn(const Vec3& along, const Vec3& normal) {   // [1]
  constexpr double kEndOn = 0.3;               // [1] sine of the angle between thread and normal
  return (normal - normal.dot(along) * along).squaredNorm() <= kEndOn * kEndOn;
}

/// Thread feels nothing along itself but friction: over an edge the nearest face changes from sample to sample and from step to step, and
/// a push along the thread would draw it to and fro. End on, it is a point like any other.
Vec3 acrossThread(const Model& m, const StrandState& s, const StrandSample& x, const Vec3& normal) {   // [1]
  if (!m.params.thread.knots || !x.thread) return normal;
  const Vec3 along = strandTangent(m.strand, s, x.coordinate);
  return endOn(along, normal) ? normal : Vec3((normal - normal.dot(along) * along).normalized());
}

/// Thread that lies in the wall end on but does not end there has sunk through an edge: a push along it would hook it there (a knot tied over it keeps less).
/// It leaves over the edge, across itself; false where there is no such way, but between two bowels, where it is drawn back (pierced_wall.h). A bend that
/// only now meets the wall with its tip is stopped like anything else.
bool leavesAcross(const Model& m, const StrandSample& x, const State& s, SurfacePoint& near) {
  if (!m.params.thread.knots || !x.thread || s.cut || isEnd(m, s, x.index)) return true;
  const Vec3 along = strandTangent(m.strand, s.strand, x.coordinate);
  const bool outside = near.normal.dot(x.position - near.point) >= 0.0;   // as the step begins
  if (outside || !endOn(along, near.normal)) return true;
  near = outAcross(m, x, near, s);
  return m.bowels.count > 1 || !endOn(along, near.normal);
}

/// The push of the last step that still counts. Between two bowels, thread caught between two walls meets now the one, now the other: what the one pushed is
/// not the other's push, or the two would pump each other up.  [N] [1]
double carriedPush(const Model& m, const StrandSample& x, const StrandContact* old, const Vec3& normal) {
  if (!old) return 0.0;
  if (m.bowels.count < 2 || !m.params.thread.knots || !x.thread) return old->normalForce;
  return std::fmin(old->normalForce, std::fmax(0.0, old->force.dot(normal)));
}

/// Does the thread go right through the wall between the sample before, whose contact is the last one found, and this one? Fine nodes lie
/// closer than the wall is thick: pushed out on either side they would pull the thread apart, and shake the wall.  [1]
bool throughWall(const Model& m, const StrandSample& x, const State& s, int fresh, int triangle, const Vec3& normal) {
  constexpr double kOpposed = -0.3;            // [1]
  if (m.bowels.count < 2 || !m.params.thread.knots || !x.thread || fresh == 0) return false;
  const StrandContact& before = s.work.freshContacts[fresh - 1];
  return before.sample + 1 == x.index && oppositeFaces(m, before.feature, triangle) && before.force.dot(normal) < kOpposed;
}

/// Is thread that is found deep in the tissue let out of it slowly? Not where tissue is cut: over those edges the stitches then do not close
/// (`altemeier`). Where it is not tied only what an edge has cut into (touchBetween).
bool leavesSlowly(const Model& m, const State& s, const StrandSample& x) {
  if (!m.params.thread.knots) return x.index >= sampleCount(m.strand);
  return m.bowels.count > 1 && x.thread && !s.cut;
}

/// Then it is not thrown out in one step (with 40 N, at an edge): taken back at once is no more than it moves in this step, or a little. Thread that is not
/// tied and comes back through a wall (pierced_wall.h) comes at that pace, however it moves.  [m]
double sunkBefore(const Model& m, const State& s, const StrandSample& x, const Touch& touch) {
  constexpr double kOutPerStep = 3e-4;         // [m]
  const double sunk = touch.normal.dot(touch.point - x.position);   // [m] as the step begins
  if (comesThrough(s.strand, x.index)) return std::fmax(0.0, sunk - kOutPerStep);
  if (!leavesSlowly(m, s, x)) return 0.0;
  const double deep = touch.normal.dot(touch.point - x.predicted), way = (x.predicted - x.position).norm();   // [m]
  return std::fmax(0.0, deep - std::fmax(kOutPerStep, way));
}

void touchTissue(const Model& m, const StrandSample& x, SurfacePoint near, State& state, int& fresh) {
  const StrandState& s = state.strand;
  if (near.triangle < 0 || near.distance < -kSkinDepth || !leavesAcross(m, x, state, near)) return;
  Touch t = touchAt(m, near, acrossThread(m, s, x, near.normal), state);
  t.point -= sunkBefore(m, state, x, t) * t.normal;
  if (throughWall(m, x, state, fresh, near.triangle, near.normal)) {
    --fresh;
    --state.work.strand.linkCount;
    return;
  }
  t.stiffness = stiffnessOn(m, x, near, state);
  const int triangles = static_cast<int>(m.surface.triangles.size());
  const StrandContact* old = previousContact(s, x.index, near.triangle, true, triangles);
  t.record = {x.index, near.triangle, carriedPush(m, x, old, t.normal), old ? old->force : Vec3(Vec3::Zero()), near.weight};
  if (m.bowels.count > 1 && m.params.thread.knots && t.record.normalForce <= 0.0) t.record.force.setZero();
  offerTouch(m, x, t, state, fresh);
}

/// Nodes that lie on both sides of an edge leave the thread between them free to cut down into the wall: it is held half-way on the edge, too, from
/// when they lie on the tissue for as long as it pushes; let go while it pushes, it would shake the wall. Not where tissue is cut: edges are no
/// wider there than nodes lie apart, and each leaves the tissue across the thread by itself. Thread that is not tied is held so only where it has cut
/// in (its nodes, on both sides of the wall, pinched it with 0.3 N for good): always, one that runs through fifty holes would not come to rest.
void touchBetween(const Model& m, int node, const SurfacePoint& before, const SurfacePoint& now, State& state, int& fresh) {
  if (state.cut) return;
  const StrandSample x = sampleBetween(m, state.strand, node);
  if (segmentAt(m.strand, x.coordinate) < kCoarse) return;
  const bool held = previousContact(state.strand, x.index, -1, true, static_cast<int>(m.surface.triangles.size())) != nullptr;
  if (!held && !overEdge(m, before, now)) return;
  const SurfacePoint out = nearBetween(m, x, node, state);
  if (m.params.thread.knots || out.distance < -kWedged) touchTissue(m, x, out, state, fresh);
}

/// Farther than `reach` even from a solid without ends: so are most samples from most solids, and this takes neither root nor quotient.
bool outOfReach(const Vec3& p, const CapsuleShape& c, double reach) {   // [m]
  constexpr double kRounding = 1e-6;           // [m] of the test behind it
  const Vec3 along = c.b - c.a;
  const double far = c.radius + reach + kRounding;   // [m]
  return (p - c.a).cross(along).squaredNorm() > far * far * along.squaredNorm();
}

void touchSolid(const Model& m, const StrandSample& x, const SolidMotion& motion, int solid, State& state, int& fresh) {
  const CapsuleShape& c = motion.now[solid];
  if (outOfReach(x.predicted, c, x.radius + kAbout)) return;
  const double f = closestOnSegment(x.predicted, c.a, c.b);
  const Vec3 axis = c.a + f * (c.b - c.a), away = x.predicted - axis;
  const double distance = away.norm();
  if (distance > c.radius + x.radius + kAbout || distance < 1e-9) return;
  const CapsuleShape& b = motion.before[solid];
  Touch t;
  t.normal = away / distance;
  t.point = axis + c.radius * t.normal;
  t.moved = axis - (b.a + f * (b.b - b.a));
  t.stiffness = kSolidStiffness;
  const int feature = static_cast<int>(m.surface.triangles.size()) + solid;
  const StrandContact* old = previousContact(state.strand, x.index, feature, false, 0);
  t.record = {x.index, feature, old ? old->normalForce : 0.0, old ? old->force : Vec3(Vec3::Zero()), {}};
  offerTouch(m, x, t, state, fresh);
}

/// A sample that the jaws hold, or that lies within their grip, is carried by the grasp instead. A tool that has gone through the wall meets none.
bool isPassed(const Model& m, const ToolState& tool, const StrandSample& x, double reach) {
  if (tool.through) return true;               // it would take the strand along through the wall
  if (tool.holdsNeedle && x.index >= m.strand.nodes) return true;
  return tool.threadCoordinate >= 0.0 && std::fabs(x.coordinate - tool.threadCoordinate) < reach;
}

bool touchesTissue(const Model& m, const State& s, int node) {
  const int triangles = static_cast<int>(m.surface.triangles.size());
  const auto isIts = [&](const StrandContact& c) { return c.sample == node && c.feature < triangles; };
  const auto& fresh = s.work.freshContacts;
  return std::any_of(fresh.begin(), fresh.begin() + s.work.freshCount, isIts);
}

/// Did it go far, or elsewhere than where its contacts were looked for?
bool hasStrayed(const StrandSample& x, const Vec3& end) {   // [m]
  constexpr double kAside = 0.3e-3, kFar = 1e-3;             // [m]
  return (end - x.predicted).squaredNorm() > kAside * kAside || (end - x.position).squaredNorm() > kFar * kFar;
}

}  // namespace

void linkContacts(const Model& m, const SolidMotion& motion, State& state) {
  int fresh = 0;
  state.work.boxes.filled = false;             // of an earlier step
  const double jawReach = 4e-3;                // [m] of thread on either side of the jaws
  SurfacePoint before;
  for (int i = 0; i < sampleCount(m.strand); ++i) {
    const StrandSample x = sampleAt(m, state.strand, i);
    const SurfacePoint near = nearTissue(m, x, state);
    if (near.triangle < 0 || near.distance >= 0.0) hasComeThrough(i, state.strand);
    if (x.thread && i > 0) {
      touchBetween(m, i, before, near, state, fresh);
      drawBack(m, i, before, near, state);
    }
    before = near;
    touchTissue(m, x, near, state, fresh);
    if (m.params.thread.knots && i < m.strand.nodes) continue;   // thread meets tools within its own solve (knotting.h)
    for (int solid = 0; solid < kSolids; ++solid) {
      const int hand = solidHand(solid);
      if (hand >= 0 && isPassed(m, state.tools[hand], x, jawReach)) continue;
      touchSolid(m, x, motion, solid, state, fresh);
    }
  }
  state.work.freshCount = fresh;
}

bool linkMetTissue(const Model& m, State& state) {
  constexpr double kIn = 0.2e-3;               // [m] less is taken back in the next step
  const int before = state.work.freshCount;
  for (int i = 0; i < m.strand.nodes; ++i) {
    StrandSample x = sampleAt(m, state.work.strandBefore, i);
    if (!hasStrayed(x, state.strand.position[i]) || touchesTissue(m, state, i)) continue;
    x.predicted = state.strand.position[i];
    const SurfacePoint met = faceOnWay(m, x, state);
    if (met.triangle < 0 || met.distance > -kIn) continue;
    Touch t = touchAt(m, met, met.normal, state);
    t.stiffness = stiffnessOn(m, x, met, state);
    t.record = {i, met.triangle, 0.0, Vec3(Vec3::Zero()), met.weight};
    offerTouch(m, x, t, state, state.work.freshCount);
  }
  return state.work.freshCount > before;
}

}  // namespace halsted
