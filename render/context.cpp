#include "render/context.h"

#include <GL/osmesa.h>

#include <stdexcept>
#include <vector>

namespace halsted::render {
namespace {

constexpr int kUnusedSide = 16;              // pixels: OSMesa insists on a picture of its own

class OsMesaContext final : public Context {
 public:
  OsMesaContext() : pixels_(4 * kUnusedSide * kUnusedSide) {
    const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 0, OSMESA_STENCIL_BITS, 0, OSMESA_ACCUM_BITS, 0,
                              OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3,
                              OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
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
    if (!OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kUnusedSide, kUnusedSide))
      throw std::runtime_error("OSMesa cannot make its OpenGL context current");
  }

 private:
  std::vector<unsigned char> pixels_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> createContext() {
  auto context = std::make_unique<OsMesaContext>();
  context->makeCurrent();
  return context;
}

}  // namespace halsted::render
