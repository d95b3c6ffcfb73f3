#pragma once
/// The organ as it is drawn: the skin over the particles with the colours of serosa, mucosa and cut rim, what has bruised it, and what a cut has opened.
#include "render/cut_surface.h"
#include "render/gpu_mesh.h"
#include "render/skin.h"
#include "sim/exchange.h"

namespace halsted::render {

class TissueSurface {
 public:
  TissueSurface(const RenderScene&, std::size_t triangleBudget);
  void update(const RenderSnapshot&);           // moves the skin and streams it
  void draw() const;
  void drawCoarse() const;                      // the particles themselves: what a shadow needs
  double openingAtRest() const { return openingAtRest_; }   // [m^2] of the lumen at the rim

 private:
  std::vector<std::array<int, 3>> surface_;               // of particles: the boundary
  Skin skin_;
  SkinPose pose_;
  GpuMesh mesh_, coarse_;
  CutSurface cut_;
  bool isCut_ = false;                                    // some of it is gone
  std::vector<std::uint32_t> fineShown_, coarseShown_;    // corners, particles: triangles that are not gone
  Buffer fineRoom_, coarseRoom_;
  void makeRoomForCuts();
  void dropWhatIsGone();
  struct PerCorner {
    Buffer buffer;
    std::vector<float> value;                             // [1] per corner
  };
  PerCorner perCorner(unsigned location) const;           // nothing yet; described to the bound vertex array
  void stream(const std::vector<float>& ofParticle, PerCorner&) const;   // [1]
  void streamBruises(const RenderSnapshot&, bool anew);   // anew: the skin has torn since
  PerCorner char_, bruise_;
  std::vector<float> bruiseOfParticle_;                   // [1]
  Buffer looks_;                                          // what never changes: colour, texture place, gloss
  std::vector<float> stream_;                             // [m], [1] position and normal per corner
  double openingAtRest_ = 0.0;                            // [m^2]
};

}  // namespace halsted::render
