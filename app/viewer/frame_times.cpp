#include "app/viewer/frame_times.h"

#include <algorithm>

namespace prairie {

void FrameTimes::add(double frame_ms) {
  frames_ms_[count_++ % kFrames] = frame_ms;
}

double FrameTimes::median_ms() const {
  const std::size_t held = std::min(count_, kFrames);
  if (held == 0) return 0.0;
  std::array<double, kFrames> sorted = frames_ms_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(held / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(held));
  return *middle;
}

}  // namespace prairie
