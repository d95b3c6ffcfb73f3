#pragma once
/// What a cut opens: the faces between tets that are seen once one side is gone, dark where heat has charred them, and which triangles
/// of the surface are gone with their tets. Faces are plain triangles of the physics mesh: a burnt edge is rough.
#include "render/gpu_mesh.h"
#include "render/skin.h"
#include "sim/exchange.h"

namespace halsted::render {

/// Triangles of the boundary, which come before those between tets.
std::size_t boundaryTriangles(const RenderScene&);

class CutSurface {
 public:
  explicit CutSurface(const RenderScene&);
  bool present() const { return triangles_.size() > boundary_; }
  /// False when the snapshot is of another scene; then nothing is cut. `changed` is true when something has gone since the last call.
  bool update(const RenderSnapshot&, bool& changed);
  const std::vector<std::uint8_t>& shown() const { return exposed_; }              // per triangle of the boundary: 0 = gone
  const std::vector<float>& charOfParticles() const { return ofParticle_; }        // [1]
  void draw() const;

 private:
  struct Vertex {
    float position[3], normal[3], uv[2];     // [m], [1], [1] in tiles
    std::uint8_t color[4], surface[4];       // as the skin's: square root of reflectance and sky; vessels, bumps, gloss, lumen
    float charred;                           // [1]
  };
  void charParticles(const RenderSnapshot&);
  void addFace(std::size_t face, const RenderSnapshot&);

  std::vector<std::array<int, 3>> triangles_;   // of particles, as in the scene
  std::size_t boundary_ = 0;                 // so many of them are not between two tets
  std::vector<std::uint8_t> exposed_;
  struct Mean { float sum = 0.0f, count = 0.0f; };   // [1] char of the bare faces round a particle: one tet alone would show as a chequer
  std::vector<float> ofParticle_;            // [1]
  std::vector<Mean> onFaces_;
  std::vector<Vertex> stream_;
  GpuMesh mesh_;
};

}  // namespace halsted::render
