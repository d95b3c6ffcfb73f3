#include "render/gl.h"

#include <stdexcept>

namespace halsted::render {
namespace {

GLuint compile(GLenum kind, const std::string& text) {
  const GLuint shader = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  char log[2048] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw std::runtime_error(std::string("shader does not compile: ") + log);
}

void bindSampler(GLuint program, const char* name, TextureUnit unit) {
  const GLint at = glGetUniformLocation(program, name);
  if (at >= 0) glUniform1i(at, unit);
}

}  // namespace

Program makeProgram(const std::string& vertex, const std::string& fragment) {
  const GLuint v = compile(GL_VERTEX_SHADER, vertex), f = compile(GL_FRAGMENT_SHADER, fragment);
  Program program{GlName<destroyProgram>(glCreateProgram())};
  glAttachShader(program.id, v);
  glAttachShader(program.id, f);
  glLinkProgram(program.id);
  glDeleteShader(v);
  glDeleteShader(f);
  GLint good = 0;
  glGetProgramiv(program.id, GL_LINK_STATUS, &good);
  if (!good) {
    char log[2048] = {};
    glGetProgramInfoLog(program.id, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("shader does not link: ") + log);
  }
  const auto find = [&](const char* name) { return glGetUniformLocation(program.id, name); };
  program.model = find("uModel");
  program.viewProjection = find("uViewProjection");
  program.shadowMatrix = find("uShadowMatrix");
  program.eye = find("uEye");
  program.tint = find("uTint");
  program.pixelSize = find("uPixelSize");
  program.open = find("uOpen");
  glUseProgram(program.id);
  bindSampler(program.id, "uSurface", kSurfaceUnit);
  bindSampler(program.id, "uReflection", kReflectionUnit);
  bindSampler(program.id, "uShadow", kShadowUnit);
  return program;
}

}  // namespace halsted::render
