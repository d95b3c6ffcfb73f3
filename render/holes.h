#pragma once
/// Puncture holes: small dark discs that face the eye.
#include <vector>

#include "render/gl.h"
#include "sim/types.h"

namespace halsted::render {

class Holes {
 public:
  explicit Holes(int capacity);
  void update(const std::vector<Vec3>& places, int count, const Vec3& eye, const Vec3& up);   // [m], [m], [1]
  void draw() const;

 private:
  struct Vertex { float position[3], corner[2]; };   // [m], [1]
  std::vector<Vertex> vertices_;
  VertexArray array_;
  Buffer buffer_;
  int capacity_ = 0, count_ = 0;
};

}  // namespace halsted::render
