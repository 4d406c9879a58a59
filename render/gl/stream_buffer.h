// Memory through which each frame's data reaches the device without a copy and without waiting: a
// persistently mapped ring of a few frames (OpenGL 4.4). A frame's part is written again only when the device
// has read it.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "render/gl/gl_objects.h"

namespace prairie {

class StreamBuffer {
 public:
  /// Begins its first frame. `frame_bytes`: what a frame is expected to write; grows when one writes more.
  explicit StreamBuffer(std::size_t frame_bytes);
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  /// Begins the next frame; waits until the device has done with that part of the ring.
  void begin_frame();

  struct Slice {
    GLuint buffer = 0;
    GLintptr offset = 0;
    GLsizeiptr bytes = 0;
  };
  /// Valid for the device until the same part of the ring begins again.
  Slice write(const void* data, std::size_t bytes);

 private:
  static constexpr std::size_t kFrames = 3;

  void allocate(std::size_t frame_bytes);

  GlName<destroy_buffer> buffer_;
  std::byte* mapped_ = nullptr;
  std::size_t frame_bytes_ = 0;
  std::size_t alignment_ = 256;
  std::size_t frame_ = 0;
  std::size_t used_ = 0;
  std::array<GLsync, kFrames> fences_{};
  std::vector<GlName<destroy_buffer>> outgrown_;  // this frame's commands may still read them
};

/// For what is drawn or computed from now on; `binding`: of shaders/shared/bindings.glsl.
void bind_storage(GLuint binding, const StreamBuffer::Slice& slice);

}  // namespace prairie
