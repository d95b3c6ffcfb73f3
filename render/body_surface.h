#pragma once
/// The layered body as it is drawn: skin, the tops of fat and muscle where a cutaway bares them, and the walls of the cut. Positions in
/// picture space: the target at the origin, +z out of the skin there.
#include <array>
#include <vector>

#include "render/gpu_mesh.h"
#include "render/skin.h"
#include "sim/exchange.h"

namespace halsted::render {

class BodySurface {
 public:
  /// `rest` are the particles of the scene in picture space. Throws std::invalid_argument when an index is out of range.
  BodySurface(const RenderScene&, const std::vector<Vec3>& rest);   // [m]
  void update(const std::vector<Vec3>& particles);                  // [m] picture space
  void drawSkin(bool cutaway) const;
  /// Only what lies near one of these along the light: where their shadows may fall. Never allocates after the first frames.
  void drawShadowed(bool cutaway, const std::vector<CapsuleShape>& casters);
  void drawInside(bool cutaway) const;                              // nothing without the cutaway
  /// Height of the skin as it stands at (x, y); `otherwise` where there is none.  [m]
  double skinHeight(double x, double y, double otherwise) const;
  double lowest() const { return lowest_; }                         // [m] of the body at rest

 private:
  Skin skin_;
  SkinPose pose_;
  GpuMesh mesh_;
  Buffer looks_;
  GpuIndices skinWhole_, skinCut_, inside_;
  std::array<std::vector<std::uint32_t>, 2> skinIndices_;           // whole, cut open
  std::vector<std::uint32_t> shadowed_;
  Buffer room_;
  std::vector<std::array<std::uint32_t, 3>> nearSkin_;              // triangles of corners: skin near the target
  std::vector<float> stream_;                                       // [m] x, y, z, [1] normal, [1] texture
  double lowest_ = 0.0;                                             // [m]
};

}  // namespace halsted::render
