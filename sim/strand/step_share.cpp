#include "sim/strand/step_share.h"

#include <algorithm>

#include "sim/strand/contact_answer.h"

namespace halsted {
namespace {

constexpr double kOvershoot = 0.25;            // [1] of the slope at the beginning, uphill at the end: so much is let pass
constexpr double kLevel = 0.1;                 // [1] of it: level enough
constexpr int kMostTrials = 8;
constexpr double kInside = 0.2;                // [1] of the interval that a trial keeps from its ends

Vec3 correctionOf(const std::vector<double>& u, const CurveWeights& w) {   // [m]
  Vec3 sum = Vec3::Zero();                     // [m]
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r) sum[r] += w.weight[a] * u[3 * (w.node + a) + r];
  return sum;
}

void gatherMoved(const StrandWork& w, ThreadContactWork& t) {
  t.moved.clear();
  ContactAnswer answer;
  for (int i = 0; i < static_cast<int>(t.points.size()); ++i) {
    const TouchingPoint& c = t.points[i];
    MovedContact moved;
    moved.relative = relativePoint(w.iterate, c, t.hands);
    moved.way = correctionOf(w.rhs, c.sample);
    if (!c.solid) moved.way -= correctionOf(w.rhs, c.partner);
    else if (c.owner >= 0) moved.way -= t.hands.tool[c.owner].correction;
    const double before = c.normal.dot(moved.relative), after = before + c.normal.dot(moved.way);   // [m]
    if (before >= c.reach && after >= c.reach) continue;
    moved.point = i;
    if (wouldAnswer(moved.relative, c, answer)) {
      moved.force = answer.force;
      moved.answer = answer.stiffness * moved.way;
    }
    t.moved.push_back(moved);
  }
}

/// Against the forces along the whole correction, at a share of it: negative while it still goes downhill.  [J]
double slopeAt(double share, double gain, const ThreadContactWork& t) {   // [1], [J]
  double slope = (share - 1.0) * gain;         // [J]
  for (const MovedContact& m : t.moved) {
    Vec3 beyond = share * m.answer - m.force;  // [N] of the real force over the linear model's
    beyond += forceAt(m.relative + share * m.way, t.points[m.point]);
    slope -= m.way.dot(beyond);
  }
  return slope;
}

double shareOfCorrection(const StrandWork& w, ThreadContactWork& t) {   // [1]
  double gain = 0.0;                           // [J]
  for (std::size_t i = 0; i < w.load.size(); ++i) gain += w.load[i] * w.rhs[i];
  gatherMoved(w, t);
  double low = 0.0, atLow = -gain, high = 1.0, atHigh = slopeAt(1.0, gain, t);   // [1], [J]
  if (!(atHigh > kOvershoot * gain)) return 1.0;
  double share = 1.0;                          // [1]
  for (int trial = 0; trial < kMostTrials; ++trial) {
    share = low + (high - low) * std::clamp(atLow / (atLow - atHigh), kInside, 1.0 - kInside);
    const double slope = slopeAt(share, gain, t);   // [J]
    if (slope > -kLevel * gain && slope < kLevel * gain) break;
    (slope > 0.0 ? high : low) = share;
    (slope > 0.0 ? atHigh : atLow) = slope;
  }
  return share;
}

}  // namespace

double takeCorrection(StrandWork& w, ThreadContactWork& t) {   // [1]
  const double share = shareOfCorrection(w, t);   // [1]
  if (share < 1.0)
    for (double& u : w.rhs) u *= share;
  shiftHands(share, t.hands);
  return share;
}

}  // namespace halsted
