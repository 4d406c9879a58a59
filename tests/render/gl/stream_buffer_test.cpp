// The ring through which frames reach the device: what is written is what the device reads, also when a frame
// outgrows it.
#include "render/gl/stream_buffer.h"

#include <numeric>

#include "tests/render/headless_test.h"

namespace prairie {
namespace {

using StreamBufferTest = HeadlessTest;

std::vector<std::uint32_t> read_back(const StreamBuffer::Slice& slice, std::size_t count) {
  GlBuffer copy("copy");
  copy.reserve(count * sizeof(std::uint32_t));
  glCopyNamedBufferSubData(slice.buffer, copy.get(), slice.offset, 0,
                           static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)));
  std::vector<std::uint32_t> values(count);
  glGetNamedBufferSubData(copy.get(), 0, static_cast<GLsizeiptr>(count * sizeof(std::uint32_t)),
                          values.data());
  return values;
}

TEST_F(StreamBufferTest, HoldsWhatAFrameWrites) {
  StreamBuffer stream(1000);
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    stream.begin_frame();
    std::vector<std::vector<std::uint32_t>> written;
    std::vector<StreamBuffer::Slice> slices;
    // From the fifth frame on, more than it was made for.
    for (std::uint32_t n = 0; n < 3 + 10 * (frame / 5); ++n) {
      written.emplace_back(40 + n);
      std::iota(written.back().begin(), written.back().end(), 1000 * frame + 50 * n);
      slices.push_back(stream.write(written.back().data(), written.back().size() * sizeof(std::uint32_t)));
    }
    for (std::size_t n = 0; n < slices.size(); ++n)
      EXPECT_EQ(read_back(slices[n], written[n].size()), written[n]);
  }
}

}  // namespace
}  // namespace prairie
