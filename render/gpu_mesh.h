#pragma once
/// Triangles in buffers of the graphics library.
#include <vector>

#include "render/gl.h"
#include "render/shape.h"
#include "render/textures.h"
#include "render/tube.h"

namespace halsted::render {

/// Owns the buffers of one mesh. `stream` replaces the vertices of a frame and never grows.
struct GpuMesh {
  VertexArray array;
  Buffer vertices, indices;
  GLsizei count = 0;

  void draw() const;
  void stream(const void* data, std::size_t bytes) const;
  void drawOnly(const std::vector<std::uint32_t>& some, const Buffer& room) const;   // these triangles; `room` holds their indices
};

GpuMesh uploadShape(const Shape&);
GpuMesh uploadTube(const Tube&);
void uploadIndices(GpuMesh&, const std::vector<std::uint32_t>&);   // to the bound vertex array

/// kOneLevel: clamped and without mip levels, which saves llvmpipe the derivatives; for pictures that are never made smaller.
enum class Sampling { kTiles, kOneLevel };
Texture uploadImage(const Image&, Sampling);

}  // namespace halsted::render
