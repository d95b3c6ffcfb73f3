#pragma once
/// Triangle shapes of rigid things, built once: instruments, rods, the operating field.
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "sim/types.h"

namespace halsted::render {

struct ShapeVertex {
  float position[3], normal[3], uv[2];       // [m], [1], [1]
  std::uint8_t color[4];                     // linear colour squared-rooted, and a channel whose meaning the shader knows
};

struct Shape {
  std::vector<ShapeVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// A skin over `rings` closed cross-sections of `sides` points each, capped at both ends.
struct Loft {
  int rings = 0, sides = 0;
  std::function<Vec3(int ring, int side)> point;                         // [m]
  std::function<std::array<double, 3>(int ring, int side)> color;        // linear [1]
};

/// Adds it with normals smooth up to 40 degrees and sharp beyond.
void addLoft(Shape&, const Loft&);

/// Surface of revolution about +z from `profile` points (radius, z) [m], from low z to high z.
void addRevolved(Shape&, const std::vector<std::array<double, 2>>& profile, const Pose&, const std::array<double, 3>& color);

/// Torus in the x-z plane of `pose`. [m]
void addRing(Shape&, double radius, double wire, const Pose& pose, const std::array<double, 3>& color);

}  // namespace halsted::render
