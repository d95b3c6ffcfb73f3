#pragma once
/// The organ as it is drawn: the skin over the particles with the colours of serosa, mucosa and cut rim.
#include "render/gpu_mesh.h"
#include "render/skin.h"
#include "sim/exchange.h"

namespace halsted::render {

class TissueSurface {
 public:
  TissueSurface(const RenderScene&, std::size_t triangleBudget);
  void update(const std::vector<Vec3>& particles);       // [m] moves the skin and streams it
  void draw() const { mesh_.draw(); }
  void drawCoarse() const { coarse_.draw(); }   // the particles themselves: what a shadow needs
  double openingAtRest() const { return openingAtRest_; }   // [m^2] of the lumen at the rim

 private:
  Skin skin_;
  SkinPose pose_;
  GpuMesh mesh_, coarse_;
  Buffer looks_;                                          // what never changes: colour, texture place, gloss
  std::vector<float> stream_;                             // [m], [1] position and normal per corner
  double openingAtRest_ = 0.0;                            // [m^2]
};

}  // namespace halsted::render
