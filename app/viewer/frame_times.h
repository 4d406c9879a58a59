// The viewer's frame time: the median of the last frames, which a single hitch does not move.
#pragma once

#include <array>
#include <cstddef>

namespace prairie {

class FrameTimes {
 public:
  void add(double frame_ms);
  /// 0 before the first frame.
  double median_ms() const;

 private:
  static constexpr std::size_t kFrames = 60;
  std::array<double, kFrames> frames_ms_{};
  std::size_t count_ = 0;  // ever added
};

}  // namespace prairie
