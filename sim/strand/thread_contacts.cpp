#include "sim/strand/thread_contacts.h"

#include <algorithm>

#include "sim/contact/geometry.h"
#include "sim/strand/contact_answer.h"
#include "sim/strand/step_share.h"
#include "sim/strand/thread_contact_search.h"

namespace halsted {
namespace {

constexpr std::size_t kMostPoints = 4 * ThreadContactState::kMaxContacts;   // in a step
constexpr double kLeave = 0.05;                // [m/s] at which what lies deeper in a tool than its force explains comes out of it,
constexpr double kPushOut = 0.3;               // [N] pushed no harder than this on a sample: what holds it there may not give way (design)

const ThreadContact* recordFor(const ThreadContactState& state, const ThreadContactWork& w, const ThreadContact& fresh) {
  for (int r = w.recordOfSample[fresh.sample]; r >= 0; r = w.nextRecord[r]) {
    const ThreadContact& old = state.contacts[r];
    if (fresh.partner < 0 || old.partner < 0) {
      if (fresh.partner == old.partner) return &old;
      continue;
    }
    const double moved = fresh.partner + fresh.place - (old.partner + old.place);   // [1] pieces
    if (moved < 1.0 && moved > -1.0) return &old;
  }
  return nullptr;
}

void indexRecords(const ThreadContactState& state, ThreadContactWork& w) {
  std::fill(w.recordOfSample.begin(), w.recordOfSample.end(), -1);
  for (int i = state.count - 1; i >= 0; --i) {
    w.nextRecord[i] = w.recordOfSample[state.contacts[i].sample];
    w.recordOfSample[state.contacts[i].sample] = i;
  }
}

/// Whether a contact is one with a hand's tool that gives way to thread.
bool gives(const TouchingPoint& c, const ThreadContactWork& w) { return c.owner >= 0 && w.hands.tool[c.owner].spring > 0.0; }

void beginCoupling(ThreadContactWork& w) {
  w.coupled.clearStructure();
  w.coupledStep = w.tie.stiffness > 0.0 && w.coupled.couple(w.tie.first.node, w.tie.second.node);
}

bool couple(const TouchingPoint& c, ThreadContactWork& w) {
  if (!c.solid) return w.coupled.couple(c.sample.node, c.partner.node);
  return !gives(c, w) || w.coupled.coupleHand(c.owner, c.sample.node);
}

/// Completes a contact whose partner and normal are known, and keeps it if there is room.
void keepPoint(TouchingPoint& c, ThreadTouch& touch) {
  ThreadContactWork& w = touch.work;
  if (w.points.size() >= kMostPoints || !couple(c, w)) {
    ++touch.state.dropped;
    return;
  }
  if (const ThreadContact* old = recordFor(touch.state, w, c.record)) {
    c.carried = old->friction - old->friction.dot(c.normal) * c.normal;
    c.normalForce = old->normalForce;
  }
  w.coupledStep = w.coupledStep || !c.solid || gives(c, w);
  w.points.push_back(c);
}

void keepPair(const StrandModel& m, const StrandState& s, const NearPair& near, ThreadTouch& touch) {
  TouchingPoint c;
  c.sample = curveWeights(near.piece, (near.sample + 0.5) / touch.work.samples[near.piece]);
  c.partner = curveWeights(near.partner, near.place);
  c.start = curvePoint(s.position, c.sample) - curvePoint(s.position, c.partner);
  const double distance = c.start.norm();
  if (!(distance > 1e-9)) return;
  c.normal = c.start / distance;
  c.reach = 2.0 * m.radius;
  c.stiffness = 0.5 * touch.work.params.stiffness * touch.work.pieceLength[near.piece] / touch.work.samples[near.piece];   // the partner's samples carry the other half
  c.coefficient = touch.work.params.friction;
  c.record = {near.piece * kMostSamples + near.sample, near.partner, near.place, 0.0, Vec3::Zero()};
  keepPoint(c, touch);
}

void keepSolid(const StrandModel& m, const StrandState& s, std::array<int, 2> where, ThreadTouch& touch, double dt) {
  const auto [sample, solid] = where;
  const int piece = sample / kMostSamples, samples = touch.work.samples[piece];
  const ThreadSolid& body = touch.work.solids[solid];
  TouchingPoint c;
  c.solid = true;
  c.owner = body.owner;
  c.sample = curveWeights(piece, (sample % kMostSamples + 0.5) / samples);
  const Vec3 own = curvePoint(s.position, c.sample);
  const double f = closestOnSegment(own, body.fromA, body.fromB);   // [1]
  const Vec3 before = body.fromA + f * (body.fromB - body.fromA);   // [m]
  c.anchor = body.a + f * (body.b - body.a);
  c.start = own - before;
  const double distance = c.start.norm();
  const Vec3 relative = dt * curvePoint(s.velocity, c.sample) - (c.anchor - before);   // [m] in this step
  c.reach = body.radius + m.radius;
  if (!(distance > 1e-9) || distance > c.reach + 0.5 * m.radius + 1.2 * relative.norm()) return;
  c.normal = c.start / distance;
  c.stiffness = touch.work.params.stiffness * touch.work.pieceLength[piece] / samples;
  c.coefficient = body.friction;
  c.record = {sample, -1 - solid, f, 0.0, Vec3::Zero()};
  // A tool may have been where the thread came free of the jaws: that depth is worked off, not sprung back.
  const ThreadContact* old = recordFor(touch.state, touch.work, c.record);
  const double push = old ? old->normalForce : 0.0, leave = push < kPushOut ? kLeave * dt : 0.0;   // [N], [m]
  c.reach = std::min(c.reach, distance + push / c.stiffness + leave + std::max(0.0, -relative.dot(c.normal)));
  keepPoint(c, touch);
}

/// Whether a sphere is farther than `reach` from where a solid was when the step began.
bool clearOf(const ThreadSolid& body, const Vec3& centre, double reach) {   // [m]
  const double f = closestOnSegment(centre, body.fromA, body.fromB);   // [1]
  return (centre - body.fromA - f * (body.fromB - body.fromA)).squaredNorm() > reach * reach;
}

void findSolids(const StrandModel& m, const StrandState& s, double dt, ThreadTouch& touch) {
  const ThreadContactWork& w = touch.work;
  const int solids = static_cast<int>(w.solids.size()), pieces = m.nodes - 2;
  for (int solid = 0; solid < solids; ++solid) {
    const ThreadSolid& body = w.solids[solid];
    const double swept = std::max((body.a - body.fromA).norm(), (body.b - body.fromB).norm());   // [m]
    const double reach = body.radius + 2.0 * m.radius + 1.5 * (dt * w.fastest + swept);          // [m]
    for (int p = 0; p < pieces; ++p) {
      const int chunk = p / kPiecesPerChunk;
      if (p % kPiecesPerChunk == 0 && clearOf(body, w.chunkCentre[chunk], reach + w.chunkRadius[chunk] + kRounding)) {
        p += kPiecesPerChunk - 1;
        continue;
      }
      if (m.place[p + 1] > body.freeFrom && m.place[p + 1] < body.freeTo) continue;
      if (touch.state.cut[p] || touch.state.cut[p + 1] || clearOf(body, w.pieces.centre(p), reach + w.pieces.radius[p])) continue;
      for (int k = 0; k < w.samples[p]; ++k) keepSolid(m, s, {p * kMostSamples + k, solid}, touch, dt);
    }
  }
}

bool answerOf(const std::vector<Vec3>& x, const GivingTools& hands, TouchingPoint& c, ContactAnswer& out) {
  return answerAt(relativePoint(x, c, hands), c, out);
}

void addOwn(const CurveWeights& w, const ContactAnswer& answer, double sign, BandedMatrix& matrix, std::vector<double>& rhs) {
  for (int a = 0; a < 3; ++a) {
    for (int r = 0; r < 3; ++r) rhs[3 * (w.node + a) + r] += sign * w.weight[a] * answer.force[r];
    for (int b = a; b < 3; ++b)
      for (int r = 0; r < 3; ++r)
        for (int k = 0; k < 3; ++k)
          matrix.add(3 * (w.node + a) + r, 3 * (w.node + b) + k, w.weight[a] * w.weight[b] * answer.stiffness(r, k));
  }
}

void addCross(const TouchingPoint& c, const Mat3& stiffness, CoupledSolve& coupled) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const int i = c.sample.node + a, j = c.partner.node + b;
      const Mat3 block = -c.sample.weight[a] * c.partner.weight[b] * stiffness;   // symmetric: the same block either way
      if (i != j) coupled.add(std::max(i, j), std::min(i, j), block);
      else coupled.add(i, j, 2.0 * block);
    }
}

/// A tangle beyond the solver's room: thread passes thread in this step, and what that lets pass is counted.
void keepSolidsOnly(ThreadTouch& touch) {
  ThreadContactWork& w = touch.work;
  beginCoupling(w);
  touch.state.dropped += static_cast<int>(std::erase_if(w.points, [&](const TouchingPoint& c) { return !c.solid || !couple(c, w); }));
  w.coupledStep = !w.coupled.empty() && w.coupled.closeStructure();
}

/// A thread cannot be bent tighter than its own width.
int firstBeyond(const StrandModel& m, int p) {
  int q = p + 3;
  while (q < m.nodes - 2 && m.place[q + 1] - m.place[p + 1] <= 4.0 * m.radius) ++q;
  return q;
}

}  // namespace

ThreadContactState restContacts(const StrandModel& m) {
  ThreadContactState s;
  s.drag.assign(m.nodes, 0.0);
  if (m.takesSet) s.set.assign(m.nodes - 2, Vec3::Zero());
  s.cut.assign(m.nodes - 1, 0);
  return s;
}

ThreadContactWork prepareContactWork(const StrandModel& m, const ThreadContactParams& params) {
  ThreadContactWork w;
  w.params = params;
  const int pieces = m.nodes - 2, chunks = (pieces + kPiecesPerChunk - 1) / kPiecesPerChunk;
  w.coupled.resize(m.nodes);
  w.points.reserve(kMostPoints);
  w.moved.reserve(kMostPoints);
  w.pieces.resize(pieces);
  w.chunkCentre.assign(chunks, Vec3::Zero());
  w.chunkRadius.assign(chunks, 0.0);
  for (int p = 0; p < pieces; ++p) {
    w.pieceLength.push_back(0.5 * (m.rest[p] + m.rest[p + 1]));
    w.firstBeyond.push_back(firstBeyond(m, p));
    w.samples.push_back(std::clamp(static_cast<int>(w.pieceLength[p] / m.radius) + 1, kFewestSamples, kMostSamples));
  }
  w.recordOfSample.assign(pieces * kMostSamples, -1);
  w.nextRecord.assign(ThreadContactState::kMaxContacts, -1);
  w.tension.assign(m.nodes - 1, 0.0);
  w.allowance.assign(pieces, 0.0);
  w.sampled.resize(pieces);
  w.near.reserve(kMostNear);
  return w;
}

void findThreadContacts(const StrandModel& m, const StrandState& s, double dt, ThreadTouch& touch) {
  ThreadContactWork& w = touch.work;
  w.points.clear();
  indexRecords(touch.state, w);
  beginCoupling(w);
  if (!searchNear(m, s, dt, touch)) ++touch.state.dropped;
  for (const NearPair& near : w.near)
    if (mayTouch(near, dt, w)) keepPair(m, s, near, touch);
  findSolids(m, s, dt, touch);
  if (w.coupledStep && !w.coupled.closeStructure()) keepSolidsOnly(touch);
  if (!w.coupledStep) w.coupled.clearStructure();
}

void assembleThreadContacts(const std::vector<Vec3>& iterate, BandedMatrix& matrix, std::vector<double>& rhs, ThreadContactWork& w) {
  if (w.coupledStep) w.coupled.clearValues();
  assembleHands(w.hands, rhs, w.coupled);
  if (w.coupledStep && w.tie.stiffness > 0.0) assembleTie(w.tie, iterate, matrix, rhs, w.coupled);
  ContactAnswer answer;
  for (TouchingPoint& c : w.points) {
    if (!answerOf(iterate, w.hands, c, answer)) continue;
    addOwn(c.sample, answer, 1.0, matrix, rhs);
    if (c.owner >= 0) addToHand(c.owner, c.sample, answer.force, answer.stiffness, w.hands, rhs, w.coupled);
    if (c.solid) continue;
    addOwn(c.partner, answer, -1.0, matrix, rhs);
    addCross(c, answer.stiffness, w.coupled);
  }
}

void settleThreadContacts(const StrandState& s, ThreadTouch& touch) {
  ThreadContactState& state = touch.state;
  int kept = 0;
  ContactAnswer answer;
  for (TouchingPoint& c : touch.work.points) {
    if (!answerOf(s.position, touch.work.hands, c, answer)) continue;
    if (kept == ThreadContactState::kMaxContacts) { ++state.dropped; continue; }
    c.record.normalForce = c.normalForce;
    c.record.friction = c.friction;
    state.contacts[kept++] = c.record;
  }
  for (int i = kept; i < state.count; ++i) state.contacts[i] = ThreadContact{};
  state.count = kept;
  settleHands(touch.work.hands);
}

Vec3 forceOnSolid(const ThreadContactWork& w, int solid) {
  Vec3 sum = Vec3::Zero();                     // [N]
  for (const TouchingPoint& c : w.points)
    if (c.record.partner == -1 - solid) sum -= c.normalForce * c.normal + c.friction;
  return sum;
}

int overloadedSegment(const StrandState& s, double breakingTension) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < s.tension.size(); ++i)
    if (s.tension[i] > s.tension[worst]) worst = i;
  return s.tension[worst] >= breakingTension ? static_cast<int>(worst) : -1;
}

}  // namespace halsted
