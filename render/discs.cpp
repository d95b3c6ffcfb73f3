#include "render/discs.h"

#include <algorithm>

namespace halsted::render {

Discs::Discs(int capacity) : array_(makeArray()), buffer_(makeBuffer()) {
  vertices_.reserve(6u * static_cast<std::size_t>(std::max(capacity, 1)));
  glBindVertexArray(array_);
  describe(buffer_, sizeof(Vertex), {{0, 3, offsetof(Vertex, position)}, {1, 2, offsetof(Vertex, corner)}, {2, 1, offsetof(Vertex, strength)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.capacity() * sizeof(Vertex)), nullptr, GL_STREAM_DRAW);
}

DiscPlace facing(const CameraView& camera, const Vec3& centre) {   // [m]
  const Vec3 toEye = (camera.eye - centre).normalized(), side = camera.up.cross(toEye).normalized();
  return {centre, side, toEye.cross(side)};
}

void Discs::add(const DiscPlace& place, double radius, double strength) {
  static constexpr float kCorner[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};   // [1]
  if (vertices_.size() + 6 > vertices_.capacity()) return;
  for (const auto& c : kCorner) {
    const Eigen::Vector3f p = (place.centre + radius * (c[0] * place.side + c[1] * place.above)).cast<float>();   // [m]
    vertices_.push_back({{p.x(), p.y(), p.z()}, {c[0], c[1]}, static_cast<float>(strength)});
  }
}

void Discs::draw() const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data());
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
}

}  // namespace halsted::render
