// How long the graphics device takes for a stage of the frame, measured by its own clock (timestamp queries).
// Reading never waits: a frame's time is known some frames later, and if the device falls so far behind that
// no query is free, frames go unmeasured. Software renderers draw in tiles, all stages of one tile before the
// next, so that there the times of stages that draw say little.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/stage_time.h"

namespace prairie {

/// Measures one stage; needs a current context from construction to destruction. Stages may overlap or
/// contain one another.
class GpuTimer {
 public:
  /// The calls between `begin` and `end` are measured; a frame's intervals add up.
  void begin();
  void end();
  /// To be called once in every frame, also in those without an interval, whose time is 0.
  void finish_frame();
  /// Of the latest frame that the device has finished; 0 before the first.
  double last_ms() const { return last_ms_; }

 private:
  struct Interval {
    GlQuery begin = make_timestamp_query();
    GlQuery end = make_timestamp_query();
  };
  struct Frame {
    std::vector<Interval> intervals;  // kept for reuse; the first `used` belong to the frame
    std::size_t used = 0;
    bool awaits_reading = false;
  };
  static constexpr std::size_t kFrames = 6;

  static bool is_finished(const Frame& frame);
  static double total_ms(const Frame& frame);

  std::array<Frame, kFrames> frames_;  // a ring
  std::size_t current_ = 0;
  std::size_t oldest_ = 0;  // not read yet
  double last_ms_ = 0.0;
};

}  // namespace prairie
