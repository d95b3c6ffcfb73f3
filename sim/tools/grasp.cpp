#include "sim/tools/grasp.h"

#include <cmath>

#include "sim/contact/geometry.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"
#include "sim/tools/come_free.h"
#include "sim/tools/cutter.h"
#include "sim/tools/instrument.h"
#include "sim/tools/jaw_rest.h"
#include "sim/tools/touch.h"

namespace halsted {
namespace {

constexpr double kCloseBelow = 0.35, kOpenAbove = 0.5;   // [1] jaw opening; the gap between them keeps a tremor from letting go
constexpr double kGripStiffness = 5e3;         // [N/m] needle or thread between steel jaws
constexpr double kGripTurn = 1.0;              // [N m/rad] needle held across the jaws
constexpr double kThreadGrip = 8.0;            // [N] above it the thread slips through the jaws
constexpr double kMostSlip = 1e-3;             // [m] a step
constexpr double kJawDepth = 7e-3;             // [m] from the tips along the jaws: how deep things may lie and be held
constexpr double kDrawIn = 0.05;               // [m/s] of thread between closing jaws, onto their middle line: at once would be a blow of its own weight
constexpr double kSlipping = 0.998;            // [1] of the squared grip: above it a held point slides
constexpr double kSlipReach = 1.5;             // [1] of the capture radius: tissue this far from the jaws has slipped out
constexpr int kScan = 64;                      // samples along the needle when looking for what the jaws hold

/// Distance of a point from the middle line of the jaws [m].
double fromJaws(const Pose& jaws, const Vec3& p) {
  const Vec3 a = jaws.position, b = jaws.apply(Vec3(0.0, 0.0, kJawDepth));
  return (p - a - closestOnSegment(p, a, b) * (b - a)).norm();
}

bool graspNeedle(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  double best = toolOf(m, s, hand).captureRadius;      // [m]
  const double arc = tipCoordinate(m.strand) - m.strand.length;
  for (int i = 0; i <= kScan; ++i) {
    const double coordinate = m.strand.length + 1e-9 + arc * i / kScan;
    const double d = fromJaws(t.proxy, strandPoint(m.strand, s.strand, coordinate));
    if (d >= best) continue;
    best = d;
    t.holdsNeedle = true;
    t.needleCoordinate = coordinate;
  }
  if (!t.holdsNeedle) return false;
  t.needleInTool.position = t.proxy.inverseApply(s.strand.needle.position);
  t.needleInTool.orientation = (t.proxy.orientation.conjugate() * s.strand.needle.orientation).normalized();
  return true;
}

bool graspThread(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  double best = toolOf(m, s, hand).captureRadius;      // [m]
  for (int i = 0; i + 1 < m.strand.nodes; ++i) {
    for (int half = 0; half < 2; ++half) {
      const double coordinate = coordinateAt(m.strand, i, 0.5 * half);
      if (partedAt(m, s, coordinate)) continue;
      const double d = fromJaws(t.proxy, strandPoint(m.strand, s.strand, coordinate));
      if (d < best) { best = d; t.threadCoordinate = coordinate; }
    }
  }
  if (t.threadCoordinate < 0.0) return false;
  t.threadInTool = t.proxy.inverseApply(strandPoint(m.strand, s.strand, t.threadCoordinate));
  return true;
}

/// Held thread comes onto the jaws' middle line, as deep as it lay between them.
void drawIn(double dt, ToolState& t) {         // [s]
  const Vec3 way = Vec3(0.0, 0.0, std::fmin(kJawDepth, std::fmax(0.0, t.threadInTool.z()))) - t.threadInTool;   // [m]
  const double far = way.norm();               // [m]
  t.threadInTool += (far > kDrawIn * dt ? kDrawIn * dt / far : 1.0) * way;
}

/// Holds the surface points nearest to the jaws' middle line, at most one a triangle vertex neighbourhood, nearest first.
bool graspTissue(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  const double reach = toolOf(m, s, hand).captureRadius;
  const Vec3 a = t.proxy.position, b = t.proxy.apply(Vec3(0.0, 0.0, kJawDepth));
  for (std::size_t f = 0; f < m.surface.triangles.size() && t.grasp.count < TissueGrasp::kMost; ++f) {
    if (s.cut && !exposed(m.surface, s.tissue.gone, static_cast<int>(f))) continue;
    const auto& v = m.surface.triangles[f];
    const auto& x = s.tissue.position;
    if ((x[v[0]] - a).norm() > reach + kJawDepth + 8e-3) continue;
    const SegmentTriangle near = closestSegmentTriangle(a, b, x[v[0]], x[v[1]], x[v[2]]);
    if (near.squaredDistance > reach * reach) continue;
    const Vec3 p = mix(near.weight, x[v[0]], x[v[1]], x[v[2]]);
    bool taken = false;
    for (int g = 0; g < t.grasp.count; ++g) taken = taken || (t.proxy.apply(t.grasp.local[g]) - p).norm() < 1.5e-3;
    if (taken) continue;
    const int g = t.grasp.count++;
    t.grasp.triangle[g] = static_cast<std::int32_t>(f);
    t.grasp.weight[g] = near.weight;
    t.grasp.local[g] = t.proxy.inverseApply(p);
    t.grasp.force[g].setZero();
  }
  return t.grasp.count > 0;
}

/// The force of one held point is no longer the tissue's.
void takeBack(const Model& m, const TissueGrasp& grasp, int g, State& s) {
  const auto& v = m.surface.triangles[grasp.triangle[g]];
  for (int k = 0; k < 3; ++k) s.work.change[v[k]] -= grasp.weight[g][k] * grasp.force[g];
}

void release(const Model& m, int hand, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  comeFree(m, hand, graspForce(t.grasp) + t.needleForce + t.threadForce, t);
  if (t.holdsNeedle) pushEvent(out, {s.step, EventKind::kNeedleReleased, hand, -1, t.needleForce.norm()});
  if (t.threadCoordinate >= 0.0) pushEvent(out, {s.step, EventKind::kThreadReleased, hand, -1, t.threadForce.norm()});
  if (t.grasp.count > 0) pushEvent(out, {s.step, EventKind::kTissueReleased, hand, -1, touchForce(t).norm()});
  letGoOfTissue(m, t.grasp, s);
  t.holdsNeedle = false;
  t.needleForce = t.threadForce = t.threadInTool = Vec3::Zero();
  t.threadCoordinate = -1.0;
  out.contact[hand].puncture = true;           // letting go may change the force at once
}

void close(const Model& m, int hand, State& s, StepOutput& out) {
  if (toolOf(m, s, hand).kind == ToolKind::kElectrocautery) return;   // its hand only switches the current
  if (cutThread(m, hand, s, out)) return;
  if (graspNeedle(m, hand, s)) pushEvent(out, {s.step, EventKind::kNeedleGrasped, hand, -1, s.tools[hand].needleCoordinate});
  else if (graspThread(m, hand, s)) pushEvent(out, {s.step, EventKind::kThreadGrasped, hand, -1, s.tools[hand].threadCoordinate});
  else if (graspTissue(m, hand, s)) pushEvent(out, {s.step, EventKind::kTissueGrasped, hand, s.tools[hand].grasp.count, 0.0});
}

/// Where the tool would be if `own` were not pulling on it [m]: the spring of the coupling is then in series with the grip's.
Pose looseTool(const Model& m, int hand, const ToolState& t, const Vec3& own) {
  return {t.device.position + t.lag + (t.force - own) / m.params.tools[hand].couplingStiffness, t.device.orientation};
}

double seriesStiffness(const Model& m, int hand) {
  return 1.0 / (1.0 / m.params.tools[hand].couplingStiffness + 1.0 / kGripStiffness);
}

}  // namespace

void dropGraspPoint(TissueGrasp& grasp, int g) {
  const int last = --grasp.count;
  grasp.triangle[g] = grasp.triangle[last];
  grasp.weight[g] = grasp.weight[last];
  grasp.local[g] = grasp.local[last];
  grasp.force[g] = grasp.force[last];
  grasp.triangle[last] = -1;
  grasp.weight[last] = {};
  grasp.local[last] = grasp.force[last] = Vec3::Zero();
}

Vec3 graspForce(const TissueGrasp& grasp) {
  Vec3 sum = Vec3::Zero();
  for (int g = 0; g < grasp.count; ++g) sum -= grasp.force[g];
  return sum;
}

void letGoOfTissue(const Model& m, TissueGrasp& grasp, State& s) {
  for (int g = 0; g < grasp.count; ++g) takeBack(m, grasp, g, s);
  while (grasp.count > 0) dropGraspPoint(grasp, grasp.count - 1);
}

namespace {

/// Where the hand is that would like to be at `wanted`: one that is held back gives way, so that it gets no farther from its tool than its force
/// holds the coupling out.  [m]
Vec3 givingWay(const ToolParams& tool, const ToolState& t, const Vec3& wanted) {
  constexpr double kHeldBack = 0.9;            // [1] of that force; a hand that nothing holds goes anywhere
  const Vec3 lead = wanted - t.proxy.position;
  const double reach = tool.handForce / tool.couplingStiffness, far = lead.norm();   // [m]
  if (far <= reach || t.force.norm() < kHeldBack * tool.handForce) return wanted;
  return t.proxy.position + reach / far * lead;
}

}  // namespace

void moveTool(const Model& m, int hand, const ToolSample& sample, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  t.device = {givingWay(m.params.tools[hand], t, sample.pose.position), sample.pose.orientation};
  if (t.ratchet && sample.jaw < kCloseBelow) t.ratchet = false;
  if (!t.ratchet) t.jaw = restingJaw(m, hand, s, std::fmin(1.0, std::fmax(0.0, sample.jaw)));
  catchUp(m.params.dt, t);
  updateProxy(m, hand, s);
  if (!t.closed && t.jaw < kCloseBelow) {
    t.closed = true;
    close(m, hand, s, out);
  } else if (t.closed && t.jaw > kOpenAbove) {
    t.closed = false;
    release(m, hand, s, out);
  }
  if (t.threadCoordinate >= 0.0) drawIn(m.params.dt, t);
}

GraspLinks linkGrasp(const Model& m, int hand, State& s) {
  const ToolState& t = s.tools[hand];
  GraspLinks links;
  StrandLink link;
  link.stiffness = seriesStiffness(m, hand) * Mat3::Identity();
  if (t.holdsNeedle) {
    const Pose tool = looseTool(m, hand, t, t.needleForce);
    Vec3 point, tangent;
    arcAt(m.strand, t.needleCoordinate, point, tangent);
    link.coordinate = t.needleCoordinate;
    link.anchor = tool.apply(t.needleInTool.apply(point));
    links.needle = s.work.strand.linkCount;
    addLink(s.work.strand, link);
    s.work.strand.turns[s.work.strand.turnCount++] = {(tool.orientation * t.needleInTool.orientation).normalized(), kGripTurn};
  }
  if (t.threadCoordinate >= 0.0) {
    link.coordinate = t.threadCoordinate;
    link.anchor = looseTool(m, hand, t, t.threadForce).apply(t.threadInTool);
    links.thread = s.work.strand.linkCount;
    addLink(s.work.strand, link);
  }
  return links;
}

namespace {

/// Past the grip the thread runs through the jaws toward the side that pulls; its end may leave them.
void slipThread(const Model& m, int hand, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  const double pull = t.threadForce.norm();    // [N]
  const bool parted = partedAt(m, s, t.threadCoordinate);
  if (pull <= kThreadGrip && !parted) return;
  const double along = -t.threadForce.dot(strandTangent(m.strand, s.strand, t.threadCoordinate));   // [N] of the jaws on the thread
  const double slip = std::fmin(kMostSlip, (pull - kThreadGrip) / seriesStiffness(m, hand));        // [m]
  t.threadCoordinate += along > 0.0 ? slip : -slip;
  if (!parted && t.threadCoordinate > 0.0 && t.threadCoordinate < m.strand.length && !partedAt(m, s, t.threadCoordinate)) return;
  pushEvent(out, {s.step, EventKind::kThreadReleased, hand, -1, pull});
  comeFree(m, hand, t.threadForce, t);
  t.threadCoordinate = -1.0;
  t.threadForce = t.threadInTool = Vec3::Zero();
  out.contact[hand].puncture = true;
}

}  // namespace

void settleGrasp(const Model& m, int hand, const GraspLinks& links, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  if (links.needle >= 0) t.needleForce = -s.work.strand.links[links.needle].force;
  if (links.thread >= 0) {
    t.threadForce = -s.work.strand.links[links.thread].force;
    slipThread(m, hand, s, out);
  }
  updateProxy(m, hand, s);
}

bool slideThroughJaws(const Model& m, const ToolParams& tool, const Pose& jaws, TissueGrasp& grasp, State& s) {
  const int before = grasp.count;
  if (before == 0) return false;
  const double limit = tool.gripForce / before;                  // [N] a point's share
  for (int g = before - 1; g >= 0; --g) {
    if (grasp.force[g].squaredNorm() < kSlipping * limit * limit) continue;
    const Vec3 now = pointOn(m.surface, s.tissue.position, grasp.triangle[g], grasp.weight[g]);
    grasp.local[g] = jaws.inverseApply(now);
    if (fromJaws(jaws, now) < kSlipReach * tool.captureRadius) continue;
    takeBack(m, grasp, g, s);
    dropGraspPoint(grasp, g);
  }
  return grasp.count < before;
}

void slipGrasp(const Model& m, int hand, State& s, StepOutput& out) {
  ToolState& t = s.tools[hand];
  const double held = touchForce(t).norm();    // [N]
  const Vec3 grip = graspForce(t.grasp);       // [N]
  if (!slideThroughJaws(m, toolOf(m, s, hand), t.proxy, t.grasp, s)) return;
  comeFree(m, hand, grip - graspForce(t.grasp), t);
  if (t.grasp.count == 0) pushEvent(out, {s.step, EventKind::kTissueReleased, hand, -1, held});
  out.contact[hand].puncture = true;           // what slips out may jump
}

void updateProxy(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  t.force = touchForce(t) + t.needleForce + t.threadForce + t.strandForce;
  t.proxy.position = t.device.position + t.lag + t.force / m.params.tools[hand].couplingStiffness;
  t.proxy.orientation = t.device.orientation;
}

}  // namespace halsted
