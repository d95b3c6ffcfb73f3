#pragma once
/// The triangles in which a body is seen: polar rings round the target point, from a few hundredths of a millimetre to the far side, for
/// the tops of skin, fat and muscle, and the walls of a stepped cutaway. Built at load time; `fillPicture` moves the vertices as the
/// force nets stand. It is read by the picture only, never by physics.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/exchange.h"
#include "sim/needling/needling.h"

namespace halsted {

/// A surface round the target to second order: height [m] over the tangent plane at (x, y) is (xx x^2 + 2 xy x y + yy y^2) / 2.
struct PicturePatch {
  Vec3 centre = Vec3::Zero(), e1 = Vec3::UnitX(), e2 = Vec3::UnitZ(), normal = Vec3::UnitY();   // [m], [1]
  double xx = 0.0, xy = 0.0, yy = 0.0;         // [1/m]
};

struct BodyPicture {
  static constexpr int kSurfaces = kLayers + 1;   // the last: the floor of the cutaway, inside the muscle
  std::vector<Vec3> rest;                      // [m] surface by surface
  int perSurface = 0;                          // vertices
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> look;                       // TissueLook
  std::vector<std::uint8_t> shown;             // Shown
  std::array<PicturePatch, kSurfaces> patch;
  Vec3 cutNormal = Vec3::UnitZ();              // [1]
};

BodyPicture bodyPicture(const NeedlingModel&, const SurfaceFrame& target);

/// Vertices as they stand now. No heap.  [m]
void fillPicture(const NeedlingModel&, const BodyPicture&, const NeedlingState&, std::span<Vec3> vertices);

}  // namespace halsted
