#pragma once
/// Where an OpenGL 3.3 core context comes from. One function, so that another off-screen library can stand in for OSMesa
/// (Mesa 25.1 drops it; EGL with a surfaceless context does the same).
///
/// A context belongs to the thread that makes it current. The library resolves every gl* symbol from libOSMesa: a program that also
/// opens a window must fetch the window's OpenGL functions at run time (glfwGetProcAddress) and must not link libGL.
#include <cstdint>
#include <memory>

namespace halsted::render {

class Context {
 public:
  virtual ~Context() = default;
  /// Makes it current on the calling thread. Throws std::runtime_error.
  virtual void makeCurrent() = 0;
  /// Waits for the drawing and leaves the picture in `pixels()`.
  virtual void finish() = 0;
  /// RGBA, top row first; valid after `finish`.
  virtual const std::uint8_t* pixels() const = 0;
};

/// An off-screen context of that size in pixels, current on the calling thread. Throws std::runtime_error with the reason.
std::unique_ptr<Context> createContext(int width, int height);

}  // namespace halsted::render
