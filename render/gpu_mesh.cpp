#include "render/gpu_mesh.h"

namespace halsted::render {
namespace {

/// Bound as an array and not as indices: that would enter the vertex array which happens to be bound.
Buffer makeIndexBuffer(std::size_t count, const std::uint32_t* data, GLenum usage) {
  Buffer buffer = makeBuffer();
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)), data, usage);
  return buffer;
}

}  // namespace

void GpuMesh::draw() const {
  if (count == 0) return;
  glBindVertexArray(array);
  glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::drawAs(const GpuIndices& other) const {
  if (other.count == 0) return;
  glBindVertexArray(array);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, other.buffer);
  glDrawElements(GL_TRIANGLES, other.count, GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
}

void GpuMesh::stream(const void* data, std::size_t bytes) const {
  glBindBuffer(GL_ARRAY_BUFFER, vertices);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
}

void GpuMesh::drawOnly(const std::vector<std::uint32_t>& some, const Buffer& room) const {
  if (some.empty()) return;
  glBindVertexArray(array);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, room);
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(some.size() * sizeof(std::uint32_t)), some.data());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(some.size()), GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
}

void uploadIndices(GpuMesh& mesh, const std::vector<std::uint32_t>& indices) {
  mesh.indices = makeBuffer();
  mesh.count = static_cast<GLsizei>(indices.size());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(), GL_STATIC_DRAW);
}

GpuIndices uploadOtherIndices(const std::vector<std::uint32_t>& indices) {
  return {makeIndexBuffer(indices.size(), indices.data(), GL_STATIC_DRAW), static_cast<GLsizei>(indices.size())};
}

Buffer makeIndexRoom(std::size_t count) { return makeIndexBuffer(count, nullptr, GL_STREAM_DRAW); }

GpuMesh uploadShape(const Shape& shape) {
  GpuMesh mesh{makeArray(), makeBuffer(), {}, 0};
  glBindVertexArray(mesh.array);
  describe(mesh.vertices, sizeof(ShapeVertex), {{0, 3, offsetof(ShapeVertex, position)}, {1, 3, offsetof(ShapeVertex, normal)},
           {2, 2, offsetof(ShapeVertex, uv)}, {3, 4, offsetof(ShapeVertex, color), GL_UNSIGNED_BYTE}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.vertices.size() * sizeof(ShapeVertex)), shape.vertices.data(), GL_STATIC_DRAW);
  uploadIndices(mesh, shape.indices);
  return mesh;
}

GpuMesh uploadTube(const Tube& tube) {
  GpuMesh mesh{makeArray(), makeBuffer(), {}, 0};
  glBindVertexArray(mesh.array);
  describe(mesh.vertices, sizeof(TubeVertex), {{0, 3, offsetof(TubeVertex, centre)}, {1, 3, offsetof(TubeVertex, normal)},
           {2, 3, offsetof(TubeVertex, radius)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(tube.vertices.size() * sizeof(TubeVertex)), tube.vertices.data(), GL_STREAM_DRAW);
  uploadIndices(mesh, tube.indices);
  return mesh;
}

Texture uploadImage(const Image& image, Sampling sampling) {
  Texture texture = makeTexture();
  const bool tiles = sampling == Sampling::kTiles;
  const GLint plain = sampling == Sampling::kNearest ? GL_NEAREST : GL_LINEAR;
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  if (tiles) glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, tiles ? GL_LINEAR_MIPMAP_NEAREST : plain);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, plain);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, tiles ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, tiles ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace halsted::render
