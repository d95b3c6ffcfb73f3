#pragma once
/// Depth as the operating lamp sees it.
#include "render/gl.h"

namespace halsted::render {

class ShadowMap {
 public:
  explicit ShadowMap(int size);
  void begin() const;                        // draws go to the map until `end`
  void end(int width, int height) const;     // pixels of the picture

 private:
  int size_;
  Texture depth_;
  Framebuffer target_;
};

}  // namespace halsted::render
