#pragma once
/// The visible surface: finer than the physics mesh, and a linear function of its particles, so following it is one sparse
/// matrix-vector product a frame. Loop subdivision (Loop 1987) with creases where the layers meet (Hoppe et al. 1994), its weights
/// multiplied out once; one step of progressive interpolation (Cheng et al. 2009) keeps the particles on the drawn surface.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/types.h"

namespace halsted::render {

inline constexpr int kCutFaceLayer = 3;      // of RenderScene::triangleLayer: between two tets, as sim/mesh.h has it

/// Sparse rows of weights over particles, each adding up to 1.
struct SkinWeights {
  std::vector<std::uint32_t> start;          // rows + 1
  std::vector<std::uint32_t> particle;
  std::vector<float> weight;                 // [1]
};

/// A corner of the drawn surface: `point` is a row of the weights; corners of one `normalSlot` share a smooth normal.
struct SkinCorner {
  std::uint32_t point = 0, normalSlot = 0;
  std::array<float, 2> uv{};                 // (turn [1], length along the tube [m]), unwrapped across the seam
  int layer = 0;
};

struct Skin {
  SkinWeights weights;
  SkinWeights flat;                          // the same points on the flat triangles of the physics mesh; empty unless the surface can be cut
  std::vector<SkinCorner> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;   // of corners; those of one surface triangle lie together
  std::uint32_t normalSlots = 0;
  int levels = 0;                                        // subdivisions made
  std::size_t surfaceTriangleOf(std::size_t triangle) const { return triangle >> (2 * levels); }
};

/// Subdivides until another level would pass `triangleBudget`. Surface and layers as in RenderScene; uv per particle.
/// Throws std::invalid_argument when an index is out of range.
Skin buildSkin(const std::vector<std::array<int, 3>>& surface, const std::vector<int>& layers,
               const std::vector<Eigen::Vector2d>& uv, std::size_t particles, std::size_t triangleBudget);

/// Fills `flat`, so that a pose of this skin can be torn. Surface and particles as it was built from.
void allowCuts(const std::vector<std::array<int, 3>>& surface, std::size_t particles, Skin&);

/// Points and smooth normals of a pose of the particles. Keeps its buffers: no allocation after the first call.
class SkinPose {
 public:
  explicit SkinPose(const Skin&);
  void update(const Skin&, const std::vector<Vec3>& particles);              // [m]
  /// Triangles of the surface that are not `shown` are gone. Smooth rows reach as far as the next ring: beside a triangle that is gone they
  /// would draw the edge after what has been carried away, so there the skin is the flat triangles themselves. For a skin that allows cuts.
  void tear(const Skin&, const std::vector<std::array<int, 3>>& surface, const std::vector<std::uint8_t>& shown);
  /// What a quantity of the particles is at a row of the weights.
  float at(const Skin&, std::uint32_t row, const std::vector<float>& ofParticle) const;    // [1] any unit
  const std::vector<float>& particles() const { return particles_; }                // [m] x, y, z, 0
  const float* point(std::uint32_t row) const { return &points_[4 * row]; }        // [m]
  const float* normal(std::uint32_t slot) const { return &normals_[4 * slot]; }    // [1]

 private:
  std::vector<float> particles_;             // [m] x, y, z, 0
  std::vector<float> points_;                // [m] x, y, z, 0
  std::vector<float> normals_;               // [1] x, y, z, 0
  const SkinWeights& weightsOf(const Skin& skin, std::size_t row) const { return !torn_.empty() && torn_[row] ? skin.flat : skin.weights; }
  std::vector<std::uint8_t> torn_;           // per row of the weights; empty: nothing is cut
  std::vector<std::uint8_t> shown_;          // per triangle of the surface; empty: all
  std::vector<std::uint8_t> atCut_;          // per particle: corner of a triangle that is gone
};

}  // namespace halsted::render
