#pragma once
/// Draws what a RenderSnapshot says, off screen. Same inputs, same bytes (on one kind of CPU).
///
/// Thread: use a renderer only on the thread that built it. After the first few frames `draw` grows no buffer of its own.
/// Errors: the constructor throws std::runtime_error (no OpenGL) or std::invalid_argument (a scene whose indices do not fit).
#include <memory>

#include "render/frame.h"
#include "render/hud.h"
#include "sim/exchange.h"

namespace halsted::render {

class Renderer {
 public:
  Renderer(const RenderScene&, int width, int height);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// The frame stays valid until the next call. A snapshot whose sizes do not match the scene is drawn without that part.
  const Frame& draw(const RenderSnapshot&, const HudInput&, const CameraView&);

 private:
  struct Parts;                              // OpenGL stays out of this header
  std::unique_ptr<Parts> parts_;
};

}  // namespace halsted::render
