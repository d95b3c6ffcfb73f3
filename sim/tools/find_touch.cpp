#include "sim/tools/find_touch.h"

#include <cmath>

#include "sim/contact/geometry.h"
#include "sim/tools/instrument.h"
#include "sim/tools/standing_clamps.h"
#include "sim/tools/tool_shape.h"

namespace halsted {
namespace {

constexpr int kRefreshInterval = 4;            // steps
constexpr double kNearReach = 8e-3;            // [m] beyond the shaft's radius: an edge of the mesh and four steps of fast motion
constexpr double kMargin = 0.3e-3;             // [m] contacts are made before they touch
constexpr double kMerge = 0.7e-3;              // [m] contact points closer than this are one
constexpr double kBehind = 1.0e-3;             // [m] half a wall: deeper, the other side is nearer
constexpr double kTriangleReach = 6e-3;        // [m] longest edge to expect when rejecting triangles
constexpr double kMostBack = 2e-3;             // [m] how far a tool that loses its contacts is looked after

struct Found {
  TouchPoint point;
  bool ok = false;
};

/// Contact of a capsule with one triangle; the normal pushes the tissue out of the tool.
Found touchOf(const Model& m, const CapsuleShape& c, int triangle, std::span<const Vec3> x, double margin) {   // [m]
  Found f;
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &d = x[v[2]];
  const double reject = c.radius + margin + kTriangleReach;      // [m]
  if ((a - (c.a + closestOnSegment(a, c.a, c.b) * (c.b - c.a))).squaredNorm() > reject * reject) return f;
  const SegmentTriangle near = closestSegmentTriangle(c.a, c.b, a, b, d);
  const double distance = std::sqrt(near.squaredDistance);
  if (distance > c.radius + margin) return f;
  const Vec3 axis = c.a + near.fraction * (c.b - c.a), on = mix(near.weight, a, b, d);
  const Vec3 outward = (b - a).cross(d - a).normalized();
  const double height = outward.dot(axis - on);                  // [m] of the axis over the triangle
  f.point.triangle = triangle;
  f.point.weight = near.weight;
  if (height > 1e-9 && distance > 1e-9) {
    f.point.normal = (on - axis) / distance;
    f.point.gap = distance - c.radius;
  } else if (height > -kBehind) {
    if (2.0 * height * height < near.squaredDistance - 1e-18) return f;   // passes the edge at the face's own level: it is in front of a neighbour, or free
    f.point.sunk = true;
    f.point.normal = -outward;
    f.point.gap = height - c.radius;
  } else {
    return f;
  }
  f.point.toolPoint = axis + c.radius * f.point.normal;
  f.ok = true;
  return f;
}

/// Same spot as a contact already found for this tool: keep the deeper one.
bool merged(const Model& m, const TouchPoint& fresh, std::span<const Vec3> x, int first, TouchWork& w) {
  const Vec3 p = pointOn(m.surface, x, fresh.triangle, fresh.weight);
  for (int i = first; i < w.count; ++i) {
    if ((pointOn(m.surface, x, w.point[i].triangle, w.point[i].weight) - p).squaredNorm() > kMerge * kMerge) continue;
    if (fresh.gap < w.point[i].gap) w.point[i] = fresh;
    return true;
  }
  return false;
}

void insert(const TouchPoint& fresh, int first, TouchWork& w) {
  if (w.count - first < ToolState::kMaxContacts) { w.point[w.count++] = fresh; return; }
  int shallow = first;
  for (int i = first; i < w.count; ++i)
    if (w.point[i].gap > w.point[shallow].gap) shallow = i;
  if (fresh.gap < w.point[shallow].gap) w.point[shallow] = fresh;
}

/// Contacts of the last step, and which of them are already continued by a point of this one.
using Continued = std::array<bool, ToolState::kMaxContacts>;

/// A penetration that the step began with is taken back at this pace, so that no contact pushes with more than the hand and the tissue
/// give: what is found deep inside (jaws that opened there, a face that came nearer than another) must not be flung out in a step.
constexpr double kRecover = 0.1e-3;            // [m] a step
/// Where tissue pushes a tool from both sides, as a shaft that is driven into a fold, what its contacts take back against each other is work that no hand
/// does: no more than this (in full up to 4 N), or wild hands made energy of it. Only where tissue is cut (15 mJ at a time; less than 5 elsewhere): between
/// bowel ends a tool that came out of the wall more slowly turned an edge out (`connell` on a patient's colon).
constexpr double kRecoverWork = 0.4e-3;        // [J] a step

/// With what the contacts of a tool push against each other, and not against its hand.  [N]
double squeezed(const ToolState& t) {
  Vec3 net = Vec3::Zero();                     // [N]
  double sum = 0.0;                            // [N]
  for (int i = 0; i < t.contactCount; ++i) {
    net += t.contactForce[i];
    sum += t.contactForce[i].norm();
  }
  return sum - net.norm();
}

/// A contact is found where the step begins, where tool and tissue do not overlap; their motion in the step carries its gap on. Found where
/// inertia alone takes the tissue, inside the tool when the tissue quivers, its normal would jump from step to step and keep up the quiver.
void moveOn(const Model& m, const Pose& before, const State& s, TouchPoint& p) {
  const Vec3 moved = pointOn(m.surface, s.tissue.position, p.triangle, p.weight) - pointOn(m.surface, s.work.tissue.previous, p.triangle, p.weight);
  const Vec3 now = s.tools[p.hand].proxy.apply(before.inverseApply(p.toolPoint));
  p.slide = moved - (now - p.toolPoint);
  p.gap += p.slide.dot(p.normal);
  p.toolPoint = now;
}

/// Carries the force of the last step over when the same triangle was touched; friction needs how far the tissue slid.
void carryOver(const State& s, double recover, Continued& continued, TouchPoint& p) {   // [m]
  const ToolState& t = s.tools[p.hand];
  for (int i = 0; i < t.contactCount; ++i) {
    if (continued[i] || t.contactTriangle[i] != p.triangle) continue;
    continued[i] = true;
    p.old = t.contactForce[i];
    p.force = p.old.dot(p.normal) > 0.0 ? p.old : Vec3::Zero();
    break;
  }
  const double apart = p.slide.dot(p.normal);  // [m]
  p.slide -= apart * p.normal;
  p.gap = std::fmax(p.gap, apart - recover);
}

/// Contacts of the last step that were not found again: their force goes, and the tissue's answer to that belongs to this solve.
void addGone(int hand, const Continued& continued, State& s) {
  const ToolState& t = s.tools[hand];
  TouchWork& w = s.work.touch;
  for (int i = 0; i < t.contactCount; ++i) {
    if (continued[i]) continue;
    TouchPoint p;
    p.hand = hand;
    p.gone = true;
    p.triangle = t.contactTriangle[i];
    p.weight = t.contactWeight[i];
    p.old = t.contactForce[i];
    w.point[w.count++] = p;
  }
}

/// A tool leaves tissue by the side it came in: it can have sunk below a face only where that face, or one beside it, held it in the
/// last step.
bool cameIn(const Model& m, const ToolState& t, const TouchPoint& p) {
  constexpr double kSameSide = 0.3;            // [1] cosine
  for (int i = 0; i < t.contactCount; ++i) {
    if (t.contactNormal[i].dot(p.normal) < kSameSide) continue;
    for (int u : m.surface.triangles[t.contactTriangle[i]])
      for (int v : m.surface.triangles[p.triangle])
        if (u == v) return true;
  }
  return false;
}

/// How far [m] the coupling would draw the tool toward this point, back to the device, if all contacts let go.
double drawnBack(const Model& m, const ToolState& t, const TouchPoint& p) {
  return std::fmin(kMostBack, std::fmax(0.0, -t.force.dot(p.normal) / m.params.tools[p.hand].couplingStiffness));
}

/// A normal that nearly coincides with one already taken would push twice.
bool looksElsewhere(const Vec3& normal, std::span<const TouchPoint> taken) {
  constexpr double kSameWay = 0.7;             // [1] cosine
  for (const TouchPoint& p : taken)
    if (p.normal.dot(normal) > kSameWay) return false;
  return true;
}

/// Triangles whose first corner lies within the capsule; false when there are more than the list holds.
bool listNear(const Model& m, const State& s, const CapsuleShape& around, ToolState& t) {
  t.nearCount = 0;
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f) {
    if (s.cut && !exposed(m.surface, s.tissue.gone, static_cast<int>(f))) continue;
    const Vec3& x = s.tissue.position[m.surface.triangles[f][0]];
    const Vec3 axis = around.a + closestOnSegment(x, around.a, around.b) * (around.b - around.a);
    if (!((x - axis).squaredNorm() < around.radius * around.radius)) continue;   // what is no number is nowhere: else no reach would be small enough
    if (inStandingClamp(m, s, static_cast<int>(f))) continue;
    if (t.nearCount == ToolState::kMaxNear) return false;
    t.nearTriangle[t.nearCount++] = static_cast<std::int32_t>(f);
  }
  return true;
}

}  // namespace

double recovered(const ToolState& t) {
  const double push = squeezed(t);             // [N]
  return push * kRecover > kRecoverWork ? kRecoverWork / push : kRecover;
}

bool isHeld(const Model& m, const TissueGrasp& grasp, int triangle) {
  for (int g = 0; g < grasp.count; ++g)
    for (int held : m.surface.triangles[grasp.triangle[g]])
      for (int v : m.surface.triangles[triangle])
        if (v == held) return true;
  return false;
}

void refreshNear(const Model& m, int hand, State& s) {
  if (s.step % kRefreshInterval == static_cast<unsigned>(hand)) listNearTriangles(m, hand, s);
}

void listNearTriangles(const Model& m, int hand, State& s) {
  ToolState& t = s.tools[hand];
  const ToolParams& p = toolOf(m, s, hand);
  const Vec3 tip = t.proxy.position, top = t.proxy.apply(Vec3(0.0, 0.0, p.jawLength + p.shaftLength));
  // Where the list would overflow (a shaft lying along a finely meshed wall) the farthest are left out, not the last by index.
  for (double reach = p.shaftRadius + kNearReach;; reach *= 0.9)
    if (listNear(m, s, {tip, top, reach}, t)) break;
  for (int i = t.nearCount; i < ToolState::kMaxNear; ++i) t.nearTriangle[i] = -1;
}

void findContacts(const Model& m, int hand, const Pose& before, State& s) {
  const ToolState& t = s.tools[hand];
  TouchWork& w = s.work.touch;
  const int first = w.count;
  const double back = std::fmin(kMostBack, t.force.norm() / m.params.tools[hand].couplingStiffness);   // [m]
  const auto capsules = toolCapsules(toolOf(m, s, hand), t.jaw);
  for (int c = 0; c < kSolidsPerTool && !t.through; ++c) {
    const CapsuleShape capsule = placed(capsules[c], before);
    for (int i = 0; i < t.nearCount; ++i) {
      if (isHeld(m, t.grasp, t.nearTriangle[i])) continue;
      Found f = touchOf(m, capsule, t.nearTriangle[i], s.work.tissue.previous, kMargin + back + kFastest);
      if (!f.ok || (f.point.sunk && !cameIn(m, t, f.point))) continue;
      f.point.hand = hand;
      moveOn(m, before, s, f.point);
      if (f.point.gap > kMargin + drawnBack(m, t, f.point)) continue;
      if (!merged(m, f.point, s.work.tissue.previous, first, w)) insert(f.point, first, w);
    }
  }
  Continued continued{};
  const double recover = s.cut ? recovered(t) : kRecover;        // [m]
  for (int i = first; i < w.count; ++i) carryOver(s, recover, continued, w.point[i]);
  addGone(hand, continued, s);
}

int findAhead(const Model& m, int hand, const State& s, double margin, std::span<TouchPoint> found) {   // [m]
  const ToolState& t = s.tools[hand];
  const auto capsules = toolCapsules(toolOf(m, s, hand), t.jaw);
  int count = 0;
  for (bool more = !t.through; more && count < static_cast<int>(found.size());) {
    TouchPoint best;
    best.gap = margin;
    more = false;
    for (const CapsuleShape& shape : capsules) {
      const CapsuleShape capsule = placed(shape, t.proxy);
      for (int i = 0; i < t.nearCount; ++i) {
        const Found f = touchOf(m, capsule, t.nearTriangle[i], s.tissue.position, margin);
        if (!f.ok || f.point.sunk || f.point.gap >= best.gap || !looksElsewhere(f.point.normal, found.first(count))) continue;
        best = f.point;
        more = true;
      }
    }
    if (more) found[count++] = best;
  }
  return count;
}

void appendGrasp(const Model& m, int holder, const Pose& jaws, double gripForce, const TissueGrasp& grasp, State& s) {   // [N]
  for (int g = 0; g < grasp.count; ++g) {
    TouchPoint p;
    p.hand = holder;
    p.grasp = true;
    p.triangle = grasp.triangle[g];
    p.weight = grasp.weight[g];
    p.toolPoint = jaws.apply(grasp.local[g]);
    p.slide = pointOn(m.surface, s.tissue.position, p.triangle, p.weight) - p.toolPoint;
    p.old = p.force = grasp.force[g];
    p.slipLimit = gripForce / grasp.count;
    s.work.touch.point[s.work.touch.count++] = p;
  }
}

void findGrasps(const Model& m, int hand, State& s) {
  const ToolState& t = s.tools[hand];
  appendGrasp(m, hand, t.proxy, toolOf(m, s, hand).gripForce, t.grasp, s);
}

}  // namespace halsted
