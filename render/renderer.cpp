#include "render/renderer.h"

#include "render/canvas.h"
#include "render/context.h"
#include "render/hud_drawing.h"
#include "render/painting.h"

namespace halsted::render {

struct Renderer::Parts {
  std::unique_ptr<Context> context = createContext();
  Canvas picture;
  std::unique_ptr<Painting> painting;
  HudDrawing hud;
  bool cutaway;                              // as the scene opens
  Frame frame;

  Parts(const RenderScene& scene, int width, int height)
      : picture(width, height), painting(scene.body.layers > 0 ? makeBodyPainting(scene, picture) : makeSuturePainting(scene, picture)),
        hud(scene, width, height), cutaway(scene.cutaway), frame{width, height, std::vector<std::uint8_t>(4u * width * height)} {}
};

Renderer::Renderer(const RenderScene& scene, int width, int height) : parts_(std::make_unique<Parts>(scene, width, height)) {}
Renderer::~Renderer() { parts_->context->makeCurrent(); }

const Frame& Renderer::draw(const RenderSnapshot& snapshot, const HudInput& hud, const CameraView& camera) {
  Parts& p = *parts_;
  p.context->makeCurrent();
  p.painting->draw(snapshot, camera, p.cutaway != hud.otherView);
  if (hud.visible) p.hud.draw(snapshot, hud, camera);
  p.picture.read(p.frame);
  return p.frame;
}

}  // namespace halsted::render
