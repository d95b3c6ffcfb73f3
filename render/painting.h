#pragma once
/// What a kind of scene puts into the frame beneath the head-up display. The OpenGL context is current; thread of the renderer.
#include <memory>

#include "sim/exchange.h"

namespace halsted::render {

class Canvas;

class Painting {
 public:
  virtual ~Painting() = default;
  virtual void draw(const RenderSnapshot&, const CameraView&, bool cutaway) = 0;   // onto the canvas that it was made for
};

/// An organ of a wall in an operating field, thread, needle and instruments. Both draw onto `picture`, which must outlive them.
std::unique_ptr<Painting> makeSuturePainting(const RenderScene&, const Canvas& picture);
/// A body of skin, fat and muscle, an acupuncture needle and a pressing finger.
std::unique_ptr<Painting> makeBodyPainting(const RenderScene&, const Canvas& picture);

}  // namespace halsted::render
