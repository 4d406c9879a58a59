// A world of the bench `scale` on its walk, frame by frame, and how long each frame took.
#pragma once

#include <vector>

#include "bench/bench.h"
#include "bench/scale_scene.h"
#include "bench/scale_target.h"
#include "render/frame/renderer.h"

namespace prairie {

class WalkingEye {
 public:
  /// Needs a current context. Throws what World and Renderer throw.
  WalkingEye(const ScaleGround& ground, const ScaleVariant& variant, const BenchOptions& options);

  Camera camera(int frame) const { return walk_camera(world_, frame); }
  const World& world() const { return world_; }
  Renderer& renderer() { return renderer_; }

  /// Moves the world on where wind blows, draws a frame and waits for its end. Frames before 0 warm up: they
  /// are not timed.
  void step(int frame, const OffscreenTarget& target);
  /// Forgets the times.
  void begin_again();

  const FrameStatistics& statistics() const { return statistics_; }  // of the last frame
  const std::vector<double>& frame_ms() const { return frame_ms_; }
  const std::vector<double>& plan_ms() const { return plan_ms_; }

 private:
  World world_;
  Renderer renderer_;
  FrameStatistics statistics_;
  std::vector<double> frame_ms_;
  std::vector<double> plan_ms_;
};

inline constexpr int kWarmUpFrames = 3;

}  // namespace prairie
