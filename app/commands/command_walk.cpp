// `prairie walk`: a scene's walkers, in a window or without one.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "agents/gait_of_bvh.h"
#include "app/commands/clip_options.h"
#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/replay_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/commands/window_options.h"
#include "app/outputs/frame_run.h"
#include "app/outputs/picture_file.h"
#include "app/outputs/streamed_output.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/camera_path.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/terminal/progress.h"
#include "app/terminal/usage_error.h"
#include "app/viewer/view.h"
#include "world/world.h"

namespace prairie {
namespace {

struct WalkOptions {
  std::filesystem::path folder;
  ClipOptions clip;  // has no output where nothing is to be recorded
  std::filesystem::path trajectories, gait;
  ReplayOptions replay;
  ViewerOptions viewer;

  bool records() const { return !clip.format.output.empty(); }
  bool is_headless() const {
    return clip.duration_s || records() || !trajectories.empty() || clip.state.save;
  }
};

int frames_of(const WalkOptions& options, const World& world, const std::optional<CameraPath>& path) {
  const double otherwise_s =
      world.replayed() ? std::max(world.replayed()->last_s() - world.time_s(), 0.0) : kUsualDurationS;
  return frame_count(asked_duration_s(options.clip, path, otherwise_s), options.clip.format.frame_rate,
                     options.records() ? kMostClipFrames : kMostUndrawnFrames);
}

int walk_headless(const WalkOptions& options, const GlobalOptions& globals, World& world) {
  const ClipFormat& format = options.clip.format;
  const std::optional<CameraPath> path = asked_camera_path(options.clip);
  std::optional<Clip> clip;
  if (options.records()) {
    check_picture_budget(format.size_px, globals.max_memory_bytes);
    clip.emplace(format, globals.threads);
  }
  begin_as_asked(options.clip.state, world);
  const int frames = frames_of(options, world, path);
  std::optional<Recording> recording;
  if (clip) recording.emplace(*clip, asked_view(options.clip, path, world), globals, world);
  std::optional<StreamedOutput> table;
  if (!options.trajectories.empty()) table.emplace(options.trajectories);
  {
    Progress progress("step", static_cast<std::uint64_t>(frames), globals.quiet);
    run_frames(world, frames, format.frame_rate,
               {.recording = recording ? &*recording : nullptr, .trajectories = table ? &*table : nullptr},
               progress);
  }
  if (clip) clip->finish();
  if (table) table->finish();
  save_asked_state(options.clip.state, world);
  say_done(fmt::format("{} walkers went on to {:.2f} s", world.walkers().size(), world.time_s()),
           globals.quiet);
  return kExitFine;
}

int walk_in_window(const WalkOptions& options, const GlobalOptions& globals, World& world) {
  begin_as_asked(options.clip.state, world);
  ViewerOptions viewer = options.viewer;
  // Whoever asks for a camera looks through it; else the first walker is followed.
  if (!options.clip.camera) viewer.follow = 0;
  viewer.walker_overlay = true;
  viewer.tier = options.clip.tier;
  viewer.memory_budget_bytes = globals.max_memory_bytes;
  const CameraSpec camera = camera_option(options.clip.camera_or_default(), world);
  view_world(world, placed_camera(camera, world, options.clip.format.size_px), viewer);
  return kExitFine;
}

int walk(const WalkOptions& options, const GlobalOptions& globals) {
  std::optional<Gait> gait;
  if (!options.gait.empty()) gait = gait_of(read_bvh(options.gait, "--gait"));
  World world = open_world(options.folder, globals, gait);
  replay_as_asked(options.replay, globals, world);
  if (world.walkers().empty())
    throw BadInput((options.folder / kSceneFileName).string(), "walkers", "nobody who walks",
                   "a [[walkers]] group, or --replay");
  return options.is_headless() ? walk_headless(options, globals, world)
                               : walk_in_window(options, globals, world);
}

}  // namespace

Command walk_command() {
  const auto options = std::make_shared<WalkOptions>();
  ClipOptions& clip = options->clip;
  Command command{"walk",
                  "Lets a scene's walkers walk, in a window or, with --duration and the like, without"};
  command.options = {
      scene_folder_option(options->folder),
      clip_duration_option(clip,
                           "Without a window, for so many seconds (10, the path's, or all of the tracks)"),
      {.names = "--trajectories",
       .type = "FILE.csv",
       .help = "Write where everybody is, each 1/fps s; - is stdout",
       .target = text_into(options->trajectories)},
      {.names = "--record",
       .type = "FILE|FOLDER",
       .help = "Draw a clip without a window: a video that ends in .mp4, or a folder of pictures",
       .target = text_into(clip.format.output)},
      replay_option(options->replay),
      replay_at_option(options->replay),
      replay_fps_option(options->replay),
      {.names = "--gait",
       .type = "FILE.bvh",
       .help = "Walk as in this recorded motion",
       .target = text_into(options->gait)},
      clip_camera_option(clip),
      clip_path_option(clip, "Where the clip's camera goes, as for record", "--record"),
      clip_rate_option(clip, "Frames, and lines of each walker, a second (30)"),
      time_option(clip.state),
      load_state_option(clip.state),
      save_state_option(clip.state),
      picture_size_option(clip.format.size_px),
      parallel_option(clip.parallel_height_m),
      picture_tier_option(clip.tier),
      picture_samples_option(clip.samples),
      {.names = "--msaa",
       .help = "In the window: smooth edges with 4 samples per pixel",
       .target = &options->viewer.msaa},
      {.names = "--paused",
       .help = "In the window: time stands still at first; P lets it go on",
       .target = &options->viewer.paused},
      window_frames_option(options->viewer),
      window_screenshot_option(options->viewer),
  };
  command.footer =
      "Keys in the window are those of view.\n"
      "Examples:\n"
      "  prairie walk examples/walkers\n"
      "  prairie walk examples/walkers --duration 60 --trajectories walk.csv\n"
      "  prairie walk examples/walkers --record walk.mp4 --duration 8 --samples 4\n"
      "  prairie walk examples/walkers --replay obsmat.txt --replay-at 60,40,90 --duration 120 --save-state "
      "end.state";
  command.run = [options](const GlobalOptions& globals) { return walk(*options, globals); };
  return command;
}

}  // namespace prairie
