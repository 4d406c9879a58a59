#include "render/gl/gpu_timeline.h"

#include <algorithm>

namespace prairie {
namespace {

constexpr double kMsPerNs = 1e-6;

GLuint64 nanoseconds(const GlQuery& timestamp) {
  GLuint64 ns = 0;
  glGetQueryObjectui64v(timestamp.get(), GL_QUERY_RESULT, &ns);
  return ns;
}

}  // namespace

void GpuTimeline::begin() {
  mark(kNoStage);
}

void GpuTimeline::end(std::size_t stage) {
  mark(stage);
}

void GpuTimeline::mark(std::size_t ended) {
  Frame& frame = frames_[current_];
  if (frame.awaits_reading) return;
  if (frame.used == frame.marks.size()) frame.marks.emplace_back();
  Mark& mark = frame.marks[frame.used++];
  mark.ended = ended;
  glQueryCounter(mark.timestamp.get(), GL_TIMESTAMP);
}

void GpuTimeline::finish_frame() {
  const bool measured = !frames_[current_].awaits_reading;  // otherwise the ring was full
  while (frames_[oldest_].awaits_reading && is_finished(frames_[oldest_])) {
    last_ms_ = times_ms(frames_[oldest_]);
    frames_[oldest_].used = 0;
    frames_[oldest_].awaits_reading = false;
    oldest_ = (oldest_ + 1) % kFrames;
  }
  if (!measured) return;
  frames_[current_].awaits_reading = true;
  current_ = (current_ + 1) % kFrames;
}

bool GpuTimeline::is_finished(const Frame& frame) {
  if (frame.used == 0) return true;
  // Timestamps become available in the order in which they were asked for.
  GLuint available = GL_FALSE;
  glGetQueryObjectuiv(frame.marks[frame.used - 1].timestamp.get(), GL_QUERY_RESULT_AVAILABLE, &available);
  return available == GL_TRUE;
}

std::vector<double> GpuTimeline::times_ms(const Frame& frame) {
  std::vector<double> times_ms;
  GLuint64 before_ns = 0;
  for (std::size_t n = 0; n < frame.used; ++n) {
    const Mark& mark = frame.marks[n];
    const GLuint64 now_ns = nanoseconds(mark.timestamp);
    if (mark.ended != kNoStage) {
      times_ms.resize(std::max(times_ms.size(), mark.ended + 1));
      times_ms[mark.ended] += static_cast<double>(now_ns - before_ns) * kMsPerNs;
    }
    before_ns = now_ns;
  }
  return times_ms;
}

}  // namespace prairie
