// A world that goes on frame by frame without a window: its frames are drawn into a clip, the places of its
// walkers told in a table, or both, or neither.
#pragma once

#include "app/outputs/recording.h"
#include "app/outputs/streamed_output.h"
#include "app/terminal/frame_rate.h"
#include "app/terminal/progress.h"

namespace prairie {

class World;

inline constexpr int kMostClipFrames = 100'000;       // as many as the five digits of a picture's name count
inline constexpr int kMostUndrawnFrames = 1'000'000;  // more than nine hours of thirty a second

/// How many frames this many seconds have: at least one. Throws UsageError where that is more than `most`.
int frame_count(double duration_s, FrameRate rate, int most);

/// What becomes of each frame; what is null is left out.
struct FrameOutputs {
  Recording* recording = nullptr;          // of the world that goes on
  StreamedOutput* trajectories = nullptr;  // a trajectory table (trajectory_table.h), to which all is written
};

/// Steps the world through as many frames, of which the first shows it as it is, to the end of the last. Each
/// is drawn while the world goes on to the next one.
void run_frames(World& world, int frames, FrameRate rate, const FrameOutputs& outputs, Progress& progress);

}  // namespace prairie
