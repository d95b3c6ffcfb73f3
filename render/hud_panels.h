#pragma once
/// The dark panels behind the HUD's words: rounded, flat, translucent. Drawn without a texture, which on a processor is most of what
/// a panel costs.
#include <vector>

#include "render/gl.h"

namespace halsted::render {

class HudPanels {
 public:
  HudPanels(int width, int height);            // of the picture, pixels
  void clear() { corners_.clear(); }
  void add(float x, float y, float w, float h, float radius);   // [pixels] from the upper left corner
  void draw() const;                           // into the bound canvas

 private:
  float width_, height_;                       // [pixels]
  std::vector<float> corners_;                 // x, y of triangles in clip space [1]
  Program program_;
  VertexArray array_;
  Buffer buffer_;
};

}  // namespace halsted::render
