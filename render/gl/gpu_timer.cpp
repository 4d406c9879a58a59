#include "render/gl/gpu_timer.h"

namespace prairie {
namespace {

constexpr double kMsPerNs = 1e-6;

GLuint64 nanoseconds(const GlQuery& timestamp) {
  GLuint64 ns = 0;
  glGetQueryObjectui64v(timestamp.get(), GL_QUERY_RESULT, &ns);
  return ns;
}

}  // namespace

void GpuTimer::begin() {
  Frame& frame = frames_[current_];
  if (frame.awaits_reading) return;
  if (frame.used == frame.intervals.size()) frame.intervals.emplace_back();
  glQueryCounter(frame.intervals[frame.used].begin.get(), GL_TIMESTAMP);
}

void GpuTimer::end() {
  Frame& frame = frames_[current_];
  if (frame.awaits_reading) return;
  glQueryCounter(frame.intervals[frame.used].end.get(), GL_TIMESTAMP);
  ++frame.used;
}

void GpuTimer::finish_frame() {
  const bool measured = !frames_[current_].awaits_reading;  // otherwise the ring was full
  while (frames_[oldest_].awaits_reading && is_finished(frames_[oldest_])) {
    last_ms_ = total_ms(frames_[oldest_]);
    frames_[oldest_].used = 0;
    frames_[oldest_].awaits_reading = false;
    oldest_ = (oldest_ + 1) % kFrames;
  }
  if (!measured) return;
  frames_[current_].awaits_reading = true;
  current_ = (current_ + 1) % kFrames;
}

bool GpuTimer::is_finished(const Frame& frame) {
  if (frame.used == 0) return true;
  // Timestamps become available in the order in which they were asked for.
  GLuint available = GL_FALSE;
  glGetQueryObjectuiv(frame.intervals[frame.used - 1].end.get(), GL_QUERY_RESULT_AVAILABLE, &available);
  return available == GL_TRUE;
}

double GpuTimer::total_ms(const Frame& frame) {
  double total_ms = 0.0;
  for (std::size_t n = 0; n < frame.used; ++n) {
    const GLuint64 passed_ns = nanoseconds(frame.intervals[n].end) - nanoseconds(frame.intervals[n].begin);
    total_ms += static_cast<double>(passed_ns) * kMsPerNs;
  }
  return total_ms;
}

}  // namespace prairie
