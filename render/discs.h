#pragma once
/// Flat discs that a shader paints over what is there: needle holes, ink on skin, smoke. Never allocates after construction.
#include <vector>

#include "render/camera.h"
#include "render/gl.h"
#include "sim/types.h"

namespace halsted::render {

/// Where a disc lies: its middle, and two unit vectors across it, counter-clockwise for who sees it.
struct DiscPlace { Vec3 centre, side, above; };      // [m] [1] [1]
/// Turned to the eye.
DiscPlace facing(const CameraView&, const Vec3& centre);   // [m]

class Discs {
 public:
  explicit Discs(int capacity);                      // more than that are left out
  void clear() { vertices_.clear(); }
  void add(const DiscPlace&, double radius, double strength = 1.0);   // [m], [1] what the shader makes of it
  void draw() const;                                 // kHoleVertex

 private:
  struct Vertex { float position[3], corner[2], strength; };   // [m], [1] -1 to 1 over the disc, [1]
  std::vector<Vertex> vertices_;
  VertexArray array_;
  Buffer buffer_;
};

}  // namespace halsted::render
