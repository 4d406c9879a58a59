#include "render/gl/stream_buffer.h"

#include <algorithm>
#include <cstring>

namespace prairie {
namespace {

constexpr GLbitfield kMapping = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

std::size_t offset_alignment() {
  GLint texture = 1, storage = 1, uniform = 1;
  glGetIntegerv(GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT, &texture);
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &storage);
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &uniform);
  return static_cast<std::size_t>(std::max({texture, storage, uniform, 16}));  // powers of two
}

}  // namespace

StreamBuffer::StreamBuffer(std::size_t frame_bytes) : alignment_(offset_alignment()) {
  allocate(frame_bytes);
}

StreamBuffer::~StreamBuffer() {
  for (const GLsync fence : fences_) glDeleteSync(fence);  // silently ignores none
}

void StreamBuffer::allocate(std::size_t frame_bytes) {
  frame_bytes_ = (frame_bytes + alignment_ - 1) / alignment_ * alignment_;
  const auto bytes = static_cast<GLsizeiptr>(kFrames * frame_bytes_);
  GLuint name = 0;
  glCreateBuffers(1, &name);
  buffer_ = GlName<destroy_buffer>(name);
  glObjectLabel(GL_BUFFER, name, -1, "streamed frames");
  glNamedBufferStorage(name, bytes, nullptr, kMapping);
  mapped_ = static_cast<std::byte*>(glMapNamedBufferRange(name, 0, bytes, kMapping));
  for (GLsync& fence : fences_) {
    glDeleteSync(fence);
    fence = nullptr;
  }
  used_ = 0;
}

void StreamBuffer::begin_frame() {
  constexpr GLuint64 kOneSecondNs = 1'000'000'000;
  outgrown_.clear();
  fences_[frame_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  frame_ = (frame_ + 1) % kFrames;
  used_ = 0;
  if (fences_[frame_] == nullptr) return;
  GLenum state = GL_TIMEOUT_EXPIRED;
  while (state == GL_TIMEOUT_EXPIRED) {
    state = glClientWaitSync(fences_[frame_], GL_SYNC_FLUSH_COMMANDS_BIT, kOneSecondNs);
  }
  glDeleteSync(fences_[frame_]);
  fences_[frame_] = nullptr;
}

StreamBuffer::Slice StreamBuffer::write(const void* data, std::size_t bytes) {
  const std::size_t room = (std::max<std::size_t>(bytes, 16) + alignment_ - 1) / alignment_ * alignment_;
  if (used_ + room > frame_bytes_) {
    outgrown_.push_back(std::move(buffer_));
    allocate(std::max(2 * frame_bytes_, 2 * room));
  }
  const std::size_t offset = frame_ * frame_bytes_ + used_;
  std::memcpy(mapped_ + offset, data, bytes);
  used_ += room;
  return {buffer_.get(), static_cast<GLintptr>(offset),
          static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 16))};
}

void bind_storage(GLuint binding, const StreamBuffer::Slice& slice) {
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, slice.buffer, slice.offset, slice.bytes);
}

}  // namespace prairie
