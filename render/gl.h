#pragma once
/// OpenGL prototypes and the few owners the renderer needs. Included by .cpp files of render/ only.
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <string>
#include <utility>

namespace halsted::render {

/// Owns one OpenGL name. Must be destroyed with its context current.
template <auto Destroy>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint id) : id_(id) {}
  GlName(GlName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlName& operator=(GlName&& other) noexcept { std::swap(id_, other.id_); return *this; }
  ~GlName() { if (id_) Destroy(id_); }
  operator GLuint() const { return id_; }    // so that a name reads as the plain id in gl* calls
 private:
  GLuint id_ = 0;
};

inline void destroyBuffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void destroyArray(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void destroyTexture(GLuint id) { glDeleteTextures(1, &id); }
inline void destroyFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void destroyProgram(GLuint id) { glDeleteProgram(id); }
using Buffer = GlName<destroyBuffer>;
using VertexArray = GlName<destroyArray>;
using Texture = GlName<destroyTexture>;
using Framebuffer = GlName<destroyFramebuffer>;

inline Buffer makeBuffer() { GLuint id; glGenBuffers(1, &id); return Buffer(id); }
inline VertexArray makeArray() { GLuint id; glGenVertexArrays(1, &id); return VertexArray(id); }
inline Texture makeTexture() { GLuint id; glGenTextures(1, &id); return Texture(id); }
inline Framebuffer makeFramebuffer() { GLuint id; glGenFramebuffers(1, &id); return Framebuffer(id); }

/// Texture units are fixed, so samplers are bound once at link time.
enum TextureUnit : int { kSurfaceUnit = 0, kReflectionUnit = 1, kShadowUnit = 2 };

/// A linked program with the locations of the uniforms that all shaders share; -1 when a shader does not use one.
struct Program {
  GlName<destroyProgram> id;
  GLint model = -1, viewProjection = -1, shadowMatrix = -1, eye = -1, tint = -1, pixelSize = -1, open = -1;
};

/// Throws std::runtime_error with the compiler's log.
Program makeProgram(const std::string& vertex, const std::string& fragment);

struct Attribute { GLuint index; int components; std::size_t offset; GLenum type = GL_FLOAT; };
/// Binds `buffer` to attributes of the current vertex array.
template <std::size_t N>
void describe(const Buffer& buffer, std::size_t stride, const Attribute (&attributes)[N]) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  for (const Attribute& a : attributes) {
    glEnableVertexAttribArray(a.index);
    glVertexAttribPointer(a.index, a.components, a.type, a.type != GL_FLOAT, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(a.offset));
  }
}

}  // namespace halsted::render
