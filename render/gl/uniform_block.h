// A struct of shaders/shared/ where the shaders' uniform block reads it.
#pragma once

#include "render/gl/stream_buffer.h"

namespace prairie {

/// For all that is drawn or computed from now on in this frame. `binding`: of shaders/shared/bindings.glsl.
template <class Params>
void bind_uniform_block(StreamBuffer& stream, GLuint binding, const Params& params) {
  const StreamBuffer::Slice slice = stream.write(&params, sizeof(params));
  glBindBufferRange(GL_UNIFORM_BUFFER, binding, slice.buffer, slice.offset, sizeof(params));
}

}  // namespace prairie
