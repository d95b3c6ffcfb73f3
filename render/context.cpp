#include "render/context.h"

#include <GL/osmesa.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace halsted::render {
namespace {

class OsMesaContext final : public Context {
 public:
  OsMesaContext(int width, int height) : width_(width), height_(height), pixels_(4u * width * height) {
    const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 0,
                              OSMESA_ACCUM_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context_) throw std::runtime_error("OSMesa offers no OpenGL 3.3 core context (is libosmesa6 installed?)");
  }
  ~OsMesaContext() override {
    if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  void makeCurrent() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, width_, height_))
      throw std::runtime_error("OSMesa cannot draw a picture of " + std::to_string(width_) + "x" + std::to_string(height_));
    OSMesaPixelStore(OSMESA_Y_UP, 0);        // top row first: the flip costs nothing here
  }
  void finish() override { glFinish(); }     // OSMesa copies its tiles to `pixels_` on finish
  const std::uint8_t* pixels() const override { return pixels_.data(); }

 private:
  int width_, height_;
  std::vector<std::uint8_t> pixels_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createContext(int width, int height) {
  if (width < 16 || height < 16 || width > 8192 || height > 8192)
    throw std::runtime_error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                             " pixels is outside 16x16 to 8192x8192");
  auto context = std::make_unique<OsMesaContext>(width, height);
  context->makeCurrent();
  return context;
}

}  // namespace halsted::render
