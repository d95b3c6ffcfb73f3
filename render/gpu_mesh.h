#pragma once
/// Triangles in buffers of the graphics library.
#include <vector>

#include "render/gl.h"
#include "render/shape.h"
#include "render/textures.h"
#include "render/tube.h"

namespace halsted::render {

/// Other triangles of the same vertices.
struct GpuIndices {
  Buffer buffer;
  GLsizei count = 0;
};

/// Owns the buffers of one mesh. `stream` replaces the vertices of a frame and never grows.
struct GpuMesh {
  VertexArray array;
  Buffer vertices, indices;
  GLsizei count = 0;

  void draw() const;
  void drawAs(const GpuIndices&) const;
  void stream(const void* data, std::size_t bytes) const;
  void drawOnly(const std::vector<std::uint32_t>& some, const Buffer& room) const;   // these triangles; `room` holds their indices
};

GpuMesh uploadShape(const Shape&);
GpuMesh uploadTube(const Tube&);
/// Room for that many indices, for GpuMesh::drawOnly to fill each frame.
Buffer makeIndexRoom(std::size_t count);
GpuIndices uploadOtherIndices(const std::vector<std::uint32_t>&);
void uploadIndices(GpuMesh&, const std::vector<std::uint32_t>&);   // to the bound vertex array

/// kOneLevel: clamped and without mip levels, which saves llvmpipe the derivatives; for pictures that are never made smaller.
/// kNearest: that, and one fetch where linear filtering makes four, the dearest thing a fragment does on a CPU; for smooth pictures.
enum class Sampling { kTiles, kOneLevel, kNearest };
Texture uploadImage(const Image&, Sampling);

}  // namespace halsted::render
