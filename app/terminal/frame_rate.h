// How many frames a second has, exactly: video counts 30000/1001.
#pragma once

#include <string>

namespace prairie {

inline constexpr int kMostFramesPerS = 240;

/// `frames` in `seconds`, both above 0.
struct FrameRate {
  int frames = 30;
  int seconds = 1;

  double per_s() const { return static_cast<double>(frames) / seconds; }
  /// Of a frame, from that of frame 0.
  double time_s(int frame) const { return static_cast<double>(frame) * seconds / frames; }
  /// "30", "30000/1001"
  std::string text() const;

  bool operator==(const FrameRate&) const = default;
};

/// "24", "12.5", "30000/1001"; 23.976, 29.97, 59.94 and 119.88 are 24000/1001 and so on, as they are meant.
/// Throws UsageError that names `option` where it is none above 0 and at most kMostFramesPerS.
FrameRate frame_rate_option(const std::string& option, const std::string& text);

}  // namespace prairie
