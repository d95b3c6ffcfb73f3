#include "sim/strand/strand_trust.h"

#include <algorithm>

#include "sim/strand/thread_contact_search.h"

namespace halsted {
namespace {

constexpr double kSettled = 4e-3;              // [1] of the radius: 5 mN on a sample
constexpr double kFirstDrag = 1e3;             // [1/s]
constexpr double kRaise = 8.0, kFade = 0.7;    // [1] per attempt; per step
constexpr double kMostDrag = 5e7;              // [1/s] more leaves knots no tighter

/// The least allowance of the pieces that a node is part of.  [m]
double allowanceOf(const ThreadContactWork& w, int node) {
  const int pieces = static_cast<int>(w.allowance.size());
  double least = 1.0;                          // [m]
  for (int p = std::max(0, node - 2); p <= std::min(node, pieces - 1); ++p) least = std::min(least, w.allowance[p]);
  return least;
}

}  // namespace

void beginTouch(const StrandModel& m, const StrandState& s, double dt, ThreadTouch& touch) {
  for (double& drag : touch.state.drag) drag = drag > 1.0 ? kFade * drag : 0.0;
  std::copy(s.tension.begin(), s.tension.end(), touch.work.tension.begin());
  findThreadContacts(m, s, dt, touch);
}

bool stillMoving(const StrandModel& m, const std::vector<double>& correction, const ThreadContactWork& w) {
  double most = w.hands.moved * w.hands.moved;   // [m^2]
  for (const TouchingPoint& c : w.points)
    for (int node : {c.sample.node, c.sample.node + 1, c.sample.node + 2})
      for (int r = 0; r < 3; ++r) most = std::max(most, correction[3 * node + r] * correction[3 * node + r]);
  return most > kSettled * kSettled * m.radius * m.radius;
}

bool mustSlow(const StrandModel& m, StrandState& s, const StrandWork& w, bool settled, ThreadTouch& touch) {
  const double restless = kNarrow * m.radius;  // [m]
  bool slower = false;
  for (int i = 0; i < m.nodes; ++i) {
    const double limit = allowanceOf(touch.work, i);   // [m]
    const bool strays = (w.iterate[i] - w.inertial[i]).squaredNorm() > limit * limit && (w.iterate[i] - s.position[i]).squaredNorm() > limit * limit;
    const Vec3 last(w.rhs[3 * i], w.rhs[3 * i + 1], w.rhs[3 * i + 2]);
    if (!strays && (settled || last.squaredNorm() < 0.01 * restless * restless)) continue;
    if (touch.state.drag[i] >= kMostDrag) continue;
    touch.state.drag[i] = std::min(kMostDrag, std::max(kRaise * touch.state.drag[i], kFirstDrag));
    slower = true;
  }
  if (slower) std::copy(touch.work.tension.begin(), touch.work.tension.end(), s.tension.begin());
  return slower;
}

void assembleSnapDrag(const StrandModel& m, const StrandState& start, double dt, const ThreadTouch& touch, StrandWork& w) {
  const std::vector<double>& drag = touch.state.drag;
  for (int i = 0; i + 1 < m.nodes; ++i) {
    const double k = m.mass[i] / dt * std::max(drag[i], drag[i + 1]);   // [N/m]
    if (k == 0.0 || touch.state.cut[i]) continue;
    const Vec3 pull = k * (w.iterate[i + 1] - start.position[i + 1] - (w.iterate[i] - start.position[i]));   // [N]
    for (int c = 3 * i; c < 3 * i + 3; ++c) {
      w.matrix.add(c, c, k);
      w.matrix.add(c, c + 3, -k);
      w.matrix.add(c + 3, c + 3, k);
      w.rhs[c] += pull[c - 3 * i];
      w.rhs[c + 3] -= pull[c - 3 * i];
    }
  }
}

}  // namespace halsted
