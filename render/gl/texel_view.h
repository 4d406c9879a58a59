// Data of a frame that shaders read as a buffer texture.
#pragma once

#include "render/gl/stream_buffer.h"

namespace prairie {

class TexelView {
 public:
  explicit TexelView(GLenum format) : format_(format), texture_(make_texture(GL_TEXTURE_BUFFER)) {}
  GLuint texture() const { return texture_.get(); }
  template <typename T>
  void show(StreamBuffer& stream, std::span<const T> values) {
    const StreamBuffer::Slice slice = stream.write(values.data(), values.size_bytes());
    glTextureBufferRange(texture_.get(), format_, slice.buffer, slice.offset, slice.bytes);
  }

 private:
  GLenum format_;
  GlTexture texture_;
};

}  // namespace prairie
