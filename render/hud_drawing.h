#pragma once
/// Draws the head-up display over the finished picture with Dear ImGui, in the renderer's OpenGL context.
/// Dear ImGui keeps its current context in a global: only one thread of a program may use it, the renderer's.
#include "render/hud.h"
#include "render/hud_panels.h"

struct ImGuiContext;

namespace halsted::render {

class HudDrawing {
 public:
  HudDrawing(const RenderScene&, int width, int height);   // pixels; the OpenGL context is current
  ~HudDrawing();
  HudDrawing(const HudDrawing&) = delete;
  HudDrawing& operator=(const HudDrawing&) = delete;
  void draw(const RenderSnapshot&, const HudInput&, const CameraView&);

 private:
  ImGuiContext* context_ = nullptr;
  float width_, height_, scale_;                           // pixels, pixels, [1] of a 720-line picture
  HudPanels panels_;
  std::string title_;
  LayeredBody body_;
  std::vector<std::string> ids_, instructions_;
  std::array<std::array<ToolKind, kHands>, 2> tools_;      // first and second instruments
  int stitchesWanted_;
};

}  // namespace halsted::render
