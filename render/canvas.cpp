#include "render/canvas.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace halsted::render {
namespace {

Texture attach(GLenum where, GLenum inside, GLenum format, GLenum type, int width, int height) {
  Texture texture = makeTexture();
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(inside), width, height, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, texture, 0);
  return texture;
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height), target_(makeFramebuffer()) {
  if (width < 16 || height < 16 || width > 8192 || height > 8192)
    throw std::runtime_error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                             " pixels is outside 16x16 to 8192x8192");
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  color_ = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
  // Floating point: the software rasteriser works in it and need not convert.
  depth_ = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("this OpenGL cannot draw into a picture of " + std::to_string(width) + "x" + std::to_string(height));
}

void Canvas::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  glViewport(0, 0, width_, height_);
}

void Canvas::copyFrom(const Canvas& other) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, other.target_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void Canvas::read(Frame& frame) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_);
  glPixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);   // every Mesa has GL_MESA_pack_invert
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, frame.rgba.data());
}

}  // namespace halsted::render
