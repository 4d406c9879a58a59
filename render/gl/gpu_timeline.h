// How long the graphics device takes for the stages of a frame, which follow one another, measured by its own
// clock (timestamp queries). One timestamp ends a stage and begins the next: each costs a software renderer
// most of a millisecond, since all tiles of the picture have to pass it. Reading never waits: a frame's times
// are known some frames later, and if the device falls so far behind that no query is free, frames go
// unmeasured. Software renderers draw in tiles, all stages of one tile before the next, so that there the
// times of stages that draw say little.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "render/gl/gl_objects.h"

namespace prairie {

/// Needs a current context from construction to destruction.
class GpuTimeline {
 public:
  /// From now on stages follow one another.
  void begin();
  /// The stage of this number ends, which began with the last call of `begin` or `end`; what a stage takes in
  /// a frame adds up.
  void end(std::size_t stage);
  /// To be called once in every frame.
  void finish_frame();
  /// By stage, of the latest frame that the device has finished; stages beyond the last one measured took
  /// none.
  const std::vector<double>& last_ms() const { return last_ms_; }

 private:
  static constexpr std::size_t kNoStage = ~std::size_t{0};
  struct Mark {
    GlQuery timestamp = make_timestamp_query();
    std::size_t ended = kNoStage;
  };
  struct Frame {
    std::vector<Mark> marks;  // kept for reuse; the first `used` belong to the frame
    std::size_t used = 0;
    bool awaits_reading = false;
  };
  static constexpr std::size_t kFrames = 6;

  void mark(std::size_t ended);
  static bool is_finished(const Frame& frame);
  static std::vector<double> times_ms(const Frame& frame);

  std::array<Frame, kFrames> frames_;  // a ring
  std::size_t current_ = 0;
  std::size_t oldest_ = 0;  // not read yet
  std::vector<double> last_ms_;
};

}  // namespace prairie
