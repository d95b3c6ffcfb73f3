#include "sim/tools/tool_shape.h"

#include "sim/contact/geometry.h"
#include "sim/portable_math.h"
#include "sim/tools/instrument.h"

namespace halsted {

CapsuleShape placed(const CapsuleShape& c, const Pose& pose) { return {pose.apply(c.a), pose.apply(c.b), c.radius}; }

std::array<CapsuleShape, kSolidsPerTool> toolCapsules(const ToolParams& t, double jaw) {
  constexpr double kHalfDegree = kPi / 360.0;  // half the angle between the jaws, small enough to be its tangent [rad]
  const double open = t.jawRadius + jaw * t.jawAngleDegrees * kHalfDegree * t.jawLength;   // [m] tip offset from the middle
  const Vec3 hinge(0.0, 0.0, t.jawLength);
  if (t.kind == ToolKind::kElectrocautery)     // one blade, and its hilt
    return {CapsuleShape{Vec3::Zero(), hinge, t.jawRadius}, CapsuleShape{hinge, hinge, t.shaftRadius},
            CapsuleShape{hinge, hinge + Vec3(0.0, 0.0, t.shaftLength), t.shaftRadius}};
  const Vec3 side(t.jawRadius, 0.0, 0.0);
  return {CapsuleShape{Vec3(open, 0.0, 0.0), hinge + side, t.jawRadius}, CapsuleShape{Vec3(-open, 0.0, 0.0), hinge - side, t.jawRadius},
          CapsuleShape{hinge, hinge + Vec3(0.0, 0.0, t.shaftLength), t.shaftRadius}};
}

bool tissueWithin(const Model& m, const State& s, const CapsuleShape& c) {
  for (int v : m.surface.vertices) {
    if (s.cut && !s.cut->bare[v]) continue;    // inside, gone, or carried out of the scene
    const Vec3& x = s.tissue.position[v];
    if ((x - c.a - closestOnSegment(x, c.a, c.b) * (c.b - c.a)).squaredNorm() < c.radius * c.radius) return true;
  }
  return false;
}

bool liesInTissue(const Model& m, int hand, const Pose& tool, const State& s) {
  const ToolState& t = s.tools[hand];
  for (const CapsuleShape& shape : toolCapsules(toolOf(m, s, hand), t.jaw)) {
    const CapsuleShape c = placed(shape, tool);
    for (int i = 0; i < t.nearCount; ++i) {
      const auto& v = m.surface.triangles[t.nearTriangle[i]];
      const auto& x = s.tissue.position;
      if (closestSegmentTriangle(c.a, c.b, x[v[0]], x[v[1]], x[v[2]]).squaredDistance < c.radius * c.radius) return true;
    }
  }
  return false;
}

std::array<CapsuleShape, kSolids> worldSolids(const Model& m, const State& s) {
  std::array<CapsuleShape, kSolids> all;
  for (int hand = 0; hand < kHands; ++hand) {
    const auto parts = toolCapsules(toolOf(m, s, hand), s.tools[hand].jaw);
    for (int k = 0; k < kSolidsPerTool; ++k) all[hand * kSolidsPerTool + k] = placed(parts[k], s.tools[hand].proxy);
  }
  const RodParams& rod = m.params.anvil;
  const Vec3 nowhere(0.0, 0.0, -10.0);         // [m] a scene without an anvil: far below everything
  all[kRod] = rod.radius > 0.0 ? CapsuleShape{rod.from, rod.to, rod.radius} : CapsuleShape{nowhere, nowhere, 0.0};
  return all;
}

}  // namespace halsted
