#include "render/program.h"

#include "render/shaders.h"

namespace halsted::render {

Program programOf(const char* vertex, const char* fragment, const char* switches) {
  return makeProgram(shaderHead() + vertex, fragmentHead() + switches + fragment);
}

View eyeView(const CameraView& camera, int width, int height, const Matrix4& lamp) {
  return {viewProjection(camera, static_cast<double>(width) / height), toTexture(lamp), camera.eye, pixelSize(camera, height)};
}

View lampView(const Matrix4& lamp) { return {lamp, toTexture(lamp), Vec3::Zero(), 0.0}; }

void use(const Program& program, const View& view) {
  glUseProgram(program.id);
  const Eigen::Vector3f eye = view.eye.cast<float>();
  const Matrix4 still = Matrix4::Identity();
  glUniformMatrix4fv(program.model, 1, GL_FALSE, still.data());
  glUniformMatrix4fv(program.viewProjection, 1, GL_FALSE, view.projection.data());
  glUniformMatrix4fv(program.shadowMatrix, 1, GL_FALSE, view.lampTexture.data());
  glUniform3fv(program.eye, 1, eye.data());
  glUniform1f(program.pixelSize, static_cast<float>(view.pixelSize));
}

void place(const Program& program, const Pose& pose) {
  glUniformMatrix4fv(program.model, 1, GL_FALSE, matrixOf(pose).data());
}

void bindTexture(TextureUnit unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

Blending::Blending(Kind kind) {
  glEnable(GL_BLEND);
  if (kind == kDarken) glBlendFunc(GL_DST_COLOR, GL_ZERO);
  else glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace halsted::render
