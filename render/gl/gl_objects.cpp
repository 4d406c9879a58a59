#include "render/gl/gl_objects.h"

#include <algorithm>

namespace prairie {
namespace {

constexpr GLsizei kWholeText = -1;  // labels end in a zero

}  // namespace

void destroy_buffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
void destroy_texture(GLuint name) {
  glDeleteTextures(1, &name);
}
void destroy_framebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
void destroy_vertex_array(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
void destroy_program(GLuint name) {
  glDeleteProgram(name);
}
void destroy_query(GLuint name) {
  glDeleteQueries(1, &name);
}

GlBuffer::GlBuffer(const char* label) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  name_ = GlName<destroy_buffer>(name);
  glObjectLabel(GL_BUFFER, name, kWholeText, label);
}

void GlBuffer::reserve(std::size_t bytes) {
  if (bytes <= size_bytes_) return;
  // Whole mebibytes, so that slowly growing contents rarely ask for new storage.
  constexpr std::size_t kStep = std::size_t{1} << 20;
  size_bytes_ = bytes < kStep ? bytes : (bytes + kStep - 1) / kStep * kStep;
  glNamedBufferData(get(), static_cast<GLsizeiptr>(size_bytes_), nullptr, GL_STREAM_DRAW);
}

void GlBuffer::upload(const void* data, std::size_t bytes) {
  reserve(std::max<std::size_t>(bytes, 16));  // a storage binding must not be empty
  glNamedBufferSubData(get(), 0, static_cast<GLsizeiptr>(bytes), data);
}

GlVertexArray make_vertex_array(const char* label) {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  glObjectLabel(GL_VERTEX_ARRAY, name, kWholeText, label);
  return GlVertexArray(name);
}

GlFramebuffer make_framebuffer(const char* label) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  glObjectLabel(GL_FRAMEBUFFER, name, kWholeText, label);
  return GlFramebuffer(name);
}

GlTexture make_texture(GLenum target, const char* label) {
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  glObjectLabel(GL_TEXTURE, name, kWholeText, label);
  return GlTexture(name);
}

GlQuery make_timestamp_query() {
  GLuint name = 0;
  glCreateQueries(GL_TIMESTAMP, 1, &name);
  return GlQuery(name);
}

void set_sampling(const GlTexture& texture, const TextureSampling& sampling) {
  const auto set = [&](GLenum parameter, GLenum value) {
    glTextureParameteri(texture.get(), parameter, static_cast<GLint>(value));
  };
  set(GL_TEXTURE_MIN_FILTER, sampling.minified);
  set(GL_TEXTURE_MAG_FILTER, sampling.magnified);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    set(axis, sampling.wrap);
}

}  // namespace prairie
