#pragma once
/// Where an OpenGL 3.3 core context comes from. One function, so that another off-screen library can stand in for OSMesa
/// (Mesa 25.1 drops it; EGL with a surfaceless context does the same).
///
/// A context belongs to the thread that makes it current. The library resolves every gl* symbol from libOSMesa: a program that also
/// opens a window must fetch the window's OpenGL functions at run time (glfwGetProcAddress) and must not link libGL.
#include <memory>

namespace halsted::render {

class Context {
 public:
  virtual ~Context() = default;
  /// Makes it current on the calling thread. Throws std::runtime_error.
  virtual void makeCurrent() = 0;
};

/// A context without a picture of its own (drawing goes to framebuffer objects), current on the calling thread.
/// Throws std::runtime_error with the reason.
std::unique_ptr<Context> createContext();

}  // namespace halsted::render
