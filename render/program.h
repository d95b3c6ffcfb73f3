#pragma once
/// What paintings share: shader programs with their heads, the uniforms that every pass sets, textures on their units, blending.
/// Errors: programOf throws std::runtime_error with the compiler's log. Thread: the renderer's, its OpenGL context current.
#include "render/camera.h"
#include "render/gl.h"

namespace halsted::render {

/// Sources without their heads; `switches` are the #define lines that the fragment's source asks for.
Program programOf(const char* vertex, const char* fragment, const char* switches = "");

/// What a pass sees the scene with: the eye, or the lamp that the shadow map stands for.
struct View {
  Matrix4 projection = Matrix4::Identity();      // to clip space
  Matrix4 lampTexture = Matrix4::Identity();     // to the shadow map: toTexture of the lamp's projection
  Vec3 eye = Vec3::Zero();                       // [m]
  double pixelSize = 0.0;                        // [1] of a pixel at distance 1; 0: wires are drawn as thin as they are
};
View eyeView(const CameraView&, int width, int height, const Matrix4& lamp);     // pixels
View lampView(const Matrix4& lamp);

/// What is drawn next is drawn with this program and stands where its vertices say.
void use(const Program&, const View&);
/// What is drawn next with the program in use stands at this pose.
void place(const Program&, const Pose&);

void bindTexture(TextureUnit, const Texture&);

/// While it lives, what is drawn is mixed with what stands there.
class Blending {
 public:
  enum Kind { kOver, kDarken };                  // by its alpha, and the picture stays opaque; multiplied, as through dark glass
  explicit Blending(Kind);
  ~Blending() { glDisable(GL_BLEND); }
  Blending(const Blending&) = delete;
  Blending& operator=(const Blending&) = delete;
};

}  // namespace halsted::render
