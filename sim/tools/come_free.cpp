#include "sim/tools/come_free.h"

#include <cmath>

#include "sim/tools/find_touch.h"
#include "sim/tools/grasp.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr double kBackSpeed = 0.5;             // [m/s] of a tool that comes free: the hand's, and no farther in a step than contacts are looked for

constexpr double kMostPlaces = 1e4;            // [1] 10 m: no tool goes so far, and a damaged state must not keep the step busy for ever

/// Is tissue in the way of a tool from here to where it is?
bool runsIntoTissue(const Model& m, int hand, const Vec3& from, const State& s) {   // [m]
  const Pose& to = s.tools[hand].proxy;
  const double way = std::ceil((to.position - from).norm() / kFastest);   // [1] of kFastest
  const int places = way < kMostPlaces ? static_cast<int>(way) : 0;
  for (int k = 1; k <= places; ++k)
    if (liesInTissue(m, hand, {from + static_cast<double>(k) / places * (to.position - from), to.orientation}, s)) return true;
  return false;
}

}  // namespace

void comeFree(const Model& m, int hand, const Vec3& force, ToolState& t) { t.lag += force / m.params.tools[hand].couplingStiffness; }   // [N]

void followSlowly(const Model& m, int hand, const Vec3& from, State& s) {   // [m]
  ToolState& t = s.tools[hand];
  const Vec3 way = t.proxy.position - from;    // [m]
  const double far = way.norm();               // [m]
  if (far <= kFastest || t.through || !runsIntoTissue(m, hand, from, s)) return;
  t.lag -= (1.0 - kBackSpeed * m.params.dt / far) * way;
  updateProxy(m, hand, s);
}

void catchUp(double dt, ToolState& t) {        // [s]
  const double far = t.lag.norm(), most = kBackSpeed * dt;       // [m]
  if (far > most) t.lag *= 1.0 - most / far;
  else t.lag.setZero();
}

}  // namespace halsted
