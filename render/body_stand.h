#pragma once
/// Where a needled body stands in its picture, and what it lies on.
#include <vector>

#include "render/shape.h"
#include "sim/exchange.h"

namespace halsted::render {

/// The point that the scene asks for; null when it asks for none.
const AcupointMark* targetOf(const LayeredBody&);

/// Picture space: the target at the origin, +z out of the skin, +y toward the viewer. Lamp and mirrored room stand in it.
struct Stand {
  Vec3 origin = Vec3::Zero();                            // [m]
  Mat3 turn = Mat3::Identity();                          // [1] world to picture

  explicit Stand(const RenderScene&);
  Vec3 place(const Vec3& p) const { return turn * (p - origin); }                     // [m]
  Vec3 way(const Vec3& d) const { return turn * d; }
  Pose pose(const Pose& p) const { return {place(p.position), Quat(turn) * p.orientation}; }
  CameraView view(const CameraView& v) const { return {place(v.eye), place(v.target), way(v.up), v.fovDegrees}; }
};

std::vector<Vec3> placed(const Stand&, const std::vector<Vec3>& world);   // [m]

/// The couch, level with the lowest point of the body.  [m]
Shape makeSheet(double height);

}  // namespace halsted::render
