#pragma once
/// Round wires: the thread, smooth through its nodes with the twist of its material frame, and the needle.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/exchange.h"

namespace halsted::render {

struct TubeVertex {
  float centre[3], normal[3];                // [m], [1] the vertex stands at centre + normal * radius
  float radius, along, turn;                 // [m], [m] along the wire, [1] around it, counted from the material frame
};

struct Tube {
  static constexpr int kSides = 6;           // plus one that closes the seam of the texture
  std::vector<TubeVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// A unit vector at a right angle to this one.
Vec3 anyAcross(const Vec3& direction);

struct RingFrame {
  Vec3 centre, first, second;                // [m], [1] two unit directions across the wire
  double radius = 0.0, along = 0.0, twist = 0.0;   // [m], [m], [rad]
};
void makeIndices(int rings, Tube&);
void writeRing(const RingFrame&, int ring, Tube&);

/// Room and indices for a thread of that many nodes; `updateThread` fills the vertices and never allocates.
Tube makeThread(int nodes);
/// Catmull-Rom through `nodes`, frames transported without spin (Bishop 1975) and turned by `twist` [rad].
void updateThread(const std::vector<Vec3>& nodes, const std::vector<double>& twist, double radius, Tube&);   // [m]

/// A thread that is whole and has a knot at some of its nodes: there it is thicker. Untwisted; the same room and indices.
void updateTiedThread(std::span<const Vec3> nodes, std::span<const int> knots, double radius, Tube&);   // [m]

/// Three sides from node to node: enough for the shadow of a thread, at a sixth of the triangles.
std::vector<std::uint32_t> threadShadowIndices(int nodes);

/// The needle in its own frame: swage, round body, tapered tip.
Tube makeNeedle(const NeedleShape&);

}  // namespace halsted::render
