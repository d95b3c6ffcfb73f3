#pragma once
/// Which patches of the ground the lamp's shadows may fall on: only these are shaded again each frame.
/// Seen along the light the ground and what casts shadows lie in one plane; a patch is drawn when a caster covers any of it there.
/// Never allocates after construction.
#include "render/light.h"
#include "render/shape.h"

namespace halsted::render {

class ShadowCells {
 public:
  /// Two triangles a patch, as makeOperatingField lists them.
  explicit ShadowCells(const Shape& ground);
  void clear();
  void add(const Vec3& caster, double radius);                        // [m]
  void add(const Vec3& a, const Vec3& b, const Vec3& c);              // [m] a triangle that casts
  void add(const std::vector<Vec3>& corners, const Eigen::Matrix4d& stand);   // [m] three a triangle, and where the thing stands
  const std::vector<std::uint32_t>& indices();                        // triangles of the patches in question

 private:
  struct Box { int u0, v0, u1, v1; };                                 // inclusive cells of the mask
  static Box boxOf(const Eigen::Vector2d& low, const Eigen::Vector2d& high);   // [m] in the plane across the light
  void mark(const Eigen::Vector2d& low, const Eigen::Vector2d& high);          // [m]
  bool covered(const Box&) const;

  LampPlane plane_;
  std::vector<std::uint32_t> triangles_, indices_;
  std::vector<Box> patches_;
  std::vector<std::uint8_t> mask_;
};

}  // namespace halsted::render
