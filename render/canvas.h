#pragma once
/// A picture with depth to draw on, inside the graphics library.
#include "render/frame.h"
#include "render/gl.h"

namespace halsted::render {

class Canvas {
 public:
  Canvas(int width, int height);             // pixels; throws std::runtime_error when outside 16x16 to 8192x8192
  int width() const { return width_; }
  int height() const { return height_; }
  void bind() const;
  /// Colour and depth of a canvas of the same size: a plain copy of memory, far cheaper than drawing.
  void copyFrom(const Canvas&) const;
  void read(Frame&) const;                   // top row first; `frame` has this size

 private:
  int width_, height_;
  Texture color_, depth_;
  Framebuffer target_;
};

}  // namespace halsted::render
