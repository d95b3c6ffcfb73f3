#include "sim/tools/perforation.h"

#include <cmath>
#include <optional>

#include "sim/contact/geometry.h"
#include "sim/suture/holes.h"
#include "sim/tools/come_free.h"
#include "sim/tools/instrument.h"
#include "sim/tools/tool_shape.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kPatch = 4.5e-3;              // [m] about a place: jaws on both sides of a wall push there, what is farther off pushes on other wall
constexpr double kTurned = -0.25;              // [1] of its rest volume: the wall below a face is inside out, and not by the give of a step alone,
constexpr double kPushing = 1.5;               // [N] by a tool that is pushed, not by jaws that close (design)

/// The hardest push of a tool on one place of the wall: what two jaws squeeze between them cancels out.  [N]
double hardestPush(const Model& m, const State& s, const ToolState& t) {
  double hardest = 0.0;                        // [N]
  for (int i = 0; i < t.contactCount; ++i) {
    const Vec3 here = pointOn(m.surface, s.tissue.position, t.contactTriangle[i], t.contactWeight[i]);
    Vec3 push = Vec3::Zero();                  // [N]
    for (int j = 0; j < t.contactCount; ++j) {
      const Vec3 there = pointOn(m.surface, s.tissue.position, t.contactTriangle[j], t.contactWeight[j]);
      if ((there - here).squaredNorm() < kPatch * kPatch) push += t.contactForce[j];
    }
    hardest = std::fmax(hardest, push.norm());
  }
  return hardest;
}

/// Volume of what lies below a face over what it is at rest.  [1]
double volumeShare(const Model& m, const State& s, int triangle) {
  const int tet = m.surface.triangleTet[triangle];
  const auto& v = m.tissue.tets[tet];
  const auto& x = s.tissue.position;
  const double now = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).dot(x[v[3]] - x[v[0]]) / 6.0;   // [m^3]
  return now / m.tissue.restVolume[tet];
}

bool turnsWall(const Model& m, const State& s, const ToolState& t) {
  for (int i = 0; i < t.contactCount; ++i)
    if (volumeShare(m, s, t.contactTriangle[i]) < kTurned) return true;
  return false;
}

/// Its axis goes into a wall by one face and out of it by another, each of them pressed into the wall, which grows no thinner: the tool is not kept out.
/// A pen burns its way through.
bool pierces(const Model& m, int hand, const State& s) {
  constexpr double kOpposed = -0.5;            // [1] cosine
  if (toolOf(m, s, hand).kind == ToolKind::kElectrocautery) return false;
  const TouchWork& w = s.work.touch;
  const auto presses = [&](const TouchPoint& p) { return p.hand == hand && p.sunk && p.force.squaredNorm() > kPushing * kPushing; };
  for (int i = 0; i < w.count; ++i)
    for (int j = 0; j < i && presses(w.point[i]); ++j)
      if (presses(w.point[j]) && w.point[j].normal.dot(w.point[i].normal) < kOpposed) return true;
  return false;
}

/// The push with which it breaks the wall, if it does.  [N]
std::optional<double> breaksWith(const Model& m, int hand, const State& s) {
  const ToolState& t = s.tools[hand];
  const double strength = m.params.tissue.perforationForce, net = contactForce(t).norm();   // [N]
  const bool in = pierces(m, hand, s);
  if (!in && net <= std::fmin(strength, kPushing)) return {};
  const double push = std::fmin(hardestPush(m, s, t), net);      // [N] a tool that wall holds from all sides pushes through none
  if (in || push > strength || (push > kPushing && turnsWall(m, s, t))) return push;
  return {};
}

}  // namespace

void settlePerforation(const Model& m, int hand, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  if (t.through) {
    t.through = liesInTissue(m, hand, t.proxy, s);
    return;
  }
  const std::optional<double> push = breaksWith(m, hand, s);     // [N]
  if (!push) return;
  t.through = true;
  ++s.metrics.perforations;
  comeFree(m, hand, contactForce(t), t);
  dropContacts(m, hand, s);
  out.contact[hand].puncture = true;           // the wall gives way: the force may jump
  pushEvent(out, {s.step, EventKind::kWallPerforated, hand, s.metrics.perforations, *push});
}

}  // namespace halsted
