// OpenGL objects that own their names: made on construction, deleted on destruction, moved but never copied.
// Each has a label by which debuggers and drivers call it.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <utility>

namespace prairie {

/// Owns one OpenGL name; `Destroy` deletes it.
template <void (*Destroy)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_ != 0) Destroy(name_);
  }
  GLuint get() const { return name_; }

 private:
  GLuint name_ = 0;
};

void destroy_buffer(GLuint name);
void destroy_texture(GLuint name);
void destroy_framebuffer(GLuint name);
void destroy_vertex_array(GLuint name);
void destroy_program(GLuint name);
void destroy_query(GLuint name);

using GlTexture = GlName<destroy_texture>;
using GlFramebuffer = GlName<destroy_framebuffer>;
using GlVertexArray = GlName<destroy_vertex_array>;
using GlProgram = GlName<destroy_program>;
using GlQuery = GlName<destroy_query>;

/// A buffer whose storage grows as it is asked to.
class GlBuffer {
 public:
  explicit GlBuffer(const char* label);
  GLuint get() const { return name_.get(); }
  std::size_t size_bytes() const { return size_bytes_; }
  /// Makes room for at least `bytes`; the contents are lost if it has to grow.
  void reserve(std::size_t bytes);
  /// Replaces the contents.
  void upload(const void* data, std::size_t bytes);
  template <typename T>
  void upload(std::span<const T> values) {
    upload(values.data(), values.size_bytes());
  }

 private:
  GlName<destroy_buffer> name_;
  std::size_t size_bytes_ = 0;
};

GlVertexArray make_vertex_array(const char* label);
GlFramebuffer make_framebuffer(const char* label);
GlTexture make_texture(GLenum target, const char* label);
GlQuery make_timestamp_query();

/// How a texture is read between its texels and beyond its border.
struct TextureSampling {
  GLenum minified = GL_LINEAR;
  GLenum magnified = GL_LINEAR;
  GLenum wrap = GL_CLAMP_TO_EDGE;
};
void set_sampling(const GlTexture& texture, const TextureSampling& sampling);

}  // namespace prairie
