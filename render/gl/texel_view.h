// Data of a frame that shaders read as a buffer texture.
#pragma once

#include "render/gl/stream_buffer.h"

namespace prairie {

class TexelView {
 public:
  TexelView(GLenum format, const char* label)
      : format_(format), texture_(make_texture(GL_TEXTURE_BUFFER, label)) {}
  template <typename T>
  void show(StreamBuffer& stream, std::span<const T> values) {
    const StreamBuffer::Slice slice = stream.write(values.data(), values.size_bytes());
    glTextureBufferRange(texture_.get(), format_, slice.buffer, slice.offset, slice.bytes);
  }
  void bind(GLuint unit) const { glBindTextureUnit(unit, texture_.get()); }

 private:
  GLenum format_;
  GlTexture texture_;
};

}  // namespace prairie
