#pragma once
/// Flat discs that a shader paints over what is there: needle holes, ink on skin. Never allocates after construction.
#include <vector>

#include "render/gl.h"
#include "sim/types.h"

namespace halsted::render {

/// Where a disc lies: its middle, and two unit vectors across it, counter-clockwise for who sees it.
struct DiscPlace { Vec3 centre, side, above; };      // [m] [1] [1]

class Discs {
 public:
  explicit Discs(int capacity);                      // more than that are left out
  void clear() { vertices_.clear(); }
  void add(const DiscPlace&, double radius);         // [m]
  void draw() const;                                 // kHoleVertex

 private:
  struct Vertex { float position[3], corner[2]; };   // [m], [1] -1 to 1 over the disc
  std::vector<Vertex> vertices_;
  VertexArray array_;
  Buffer buffer_;
};

}  // namespace halsted::render
