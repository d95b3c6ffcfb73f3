#pragma once
/// Depth as the operating lamp sees it.
#include "render/gl.h"

namespace halsted::render {

class ShadowMap {
 public:
  explicit ShadowMap(int size);
  void begin() const;                        // draws go to the map until `end`
  void setBack(double share) const;          // [1] of the depth it covers: what is drawn next casts its shadow from farther away
  void end() const;                          // the map is on its texture unit; bind a canvas next

 private:
  int size_;
  Texture depth_;
  Framebuffer target_;
};

}  // namespace halsted::render
