#include "app/outputs/frame_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/outputs/trajectory_table.h"
#include "app/scenes/world_time.h"
#include "app/terminal/usage_error.h"
#include "world/world.h"

namespace prairie {

int frame_count(double duration_s, FrameRate rate, int most) {
  const double frames = std::max(std::round(duration_s * rate.per_s()), 1.0);
  if (frames <= most) return static_cast<int>(frames);
  throw UsageError("--duration", fmt::format("{} frames", frames), fmt::format("at most {}", most));
}

void run_frames(World& world, int frames, FrameRate rate, const FrameOutputs& outputs, Progress& progress) {
  const double start_s = world.time_s();
  // To a frame's time, seen and told as in it; past the last one neither.
  const auto go_on_to = [&](int frame) {
    if (frame < frames && outputs.recording) look_through(outputs.recording->camera(frame), world);
    advance_to(world, start_s + rate.time_s(frame));
    if (frame < frames && outputs.trajectories) outputs.trajectories->write(trajectory_rows(world));
  };
  if (outputs.trajectories) outputs.trajectories->write(trajectory_header());
  go_on_to(0);
  for (int frame = 0; frame < frames; ++frame) {
    const auto go_on = [&] { go_on_to(frame + 1); };
    if (outputs.recording) {
      outputs.recording->add(frame, go_on);
    } else {
      go_on();
    }
    progress.advance();
  }
}

}  // namespace prairie
