#include "render/holes.h"

#include <algorithm>

namespace halsted::render {
namespace {
constexpr double kHoleRadius = 0.62e-3;      // [m] a 0.66 mm needle leaves a hole with a bruised edge
constexpr double kLift = 0.45e-3;            // [m] toward the eye, so that the drawn wall does not hide it
}  // namespace

Holes::Holes(int capacity) : array_(makeArray()), buffer_(makeBuffer()), capacity_(std::max(capacity, 1)) {
  vertices_.resize(6u * capacity_);
  glBindVertexArray(array_);
  describe(buffer_, sizeof(Vertex), {{0, 3, offsetof(Vertex, position)}, {1, 2, offsetof(Vertex, corner)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), nullptr, GL_STREAM_DRAW);
}

void Holes::update(const std::vector<Vec3>& places, int count, const Vec3& eye, const Vec3& up) {
  static constexpr float kCorner[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};   // [1]
  count_ = std::clamp(std::min(count, static_cast<int>(places.size())), 0, capacity_);
  for (int i = 0; i < count_; ++i) {
    const Vec3 toEye = (eye - places[i]).normalized();
    const Vec3 side = up.cross(toEye).normalized(), above = toEye.cross(side);
    for (int k = 0; k < 6; ++k) {
      const Vec3 p = places[i] + kLift * toEye + kHoleRadius * (kCorner[k][0] * side + kCorner[k][1] * above);   // [m]
      vertices_[6u * i + k] = {{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())},
                               {kCorner[k][0], kCorner[k][1]}};
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(6u * count_ * sizeof(Vertex)), vertices_.data());
}

void Holes::draw() const {
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, 6 * count_);
}

}  // namespace halsted::render
