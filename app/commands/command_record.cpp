// `prairie record`: a clip without a window, as a video or as single pictures.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/commands/clip_options.h"
#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/replay_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/outputs/frame_run.h"
#include "app/outputs/picture_file.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/progress.h"
#include "world/world.h"

namespace prairie {
namespace {

struct RecordOptions {
  std::filesystem::path folder;
  ClipOptions clip;
  ReplayOptions replay;
};

int record(const RecordOptions& options, const GlobalOptions& globals) {
  const ClipFormat& format = options.clip.format;
  check_picture_budget(format.size_px, globals.max_memory_bytes);
  const std::optional<CameraPath> path = asked_camera_path(options.clip);
  const int frames =
      frame_count(asked_duration_s(options.clip, path, kUsualDurationS), format.frame_rate, kMostClipFrames);
  Clip clip(format, globals.threads);
  World world = open_world(options.folder, globals);
  const ClipView view = asked_view(options.clip, path, world);
  replay_as_asked(options.replay, globals, world);
  begin_as_asked(options.clip.state, world);
  Recording recording(clip, view, globals, world);
  {
    Progress progress("frame", static_cast<std::uint64_t>(frames), globals.quiet);
    run_frames(world, frames, format.frame_rate, {.recording = &recording}, progress);
  }
  clip.finish();
  save_asked_state(options.clip.state, world);
  say_done(fmt::format("{}: {} frames of {} × {} pixels, {} a second", format.output.string(), frames,
                       format.size_px.x, format.size_px.y, format.frame_rate.text()),
           globals.quiet);
  return kExitFine;
}

}  // namespace

Command record_command() {
  const auto options = std::make_shared<RecordOptions>();
  ClipOptions& clip = options->clip;
  Command command{"record", "Draws a clip, without a window"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "-o,--output",
       .type = "FILE|FOLDER",
       .help = "A video that ends in .mp4 (H.264, made by ffmpeg), or a folder for pictures frame-00000.png, "
               "…",
       .target = text_into(clip.format.output),
       .is_required = true},
      clip_camera_option(clip),
      clip_path_option(clip,
                       "Where it goes: lines of time_s,x_m,y_m,z_m,yaw_deg,pitch_deg[,fov_deg] after a line "
                       "of these names; z as +1.7 is above the ground"),
      clip_duration_option(clip, "Seconds (the path's, or 10)"),
      clip_rate_option(clip, "Frames a second (30)"),
      replay_option(options->replay),
      replay_at_option(options->replay),
      replay_fps_option(options->replay),
      time_option(clip.state),
      load_state_option(clip.state),
      save_state_option(clip.state),
      picture_size_option(clip.format.size_px),
      parallel_option(clip.parallel_height_m),
      picture_tier_option(clip.tier),
      picture_samples_option(clip.samples),
  };
  command.footer =
      "Examples:\n"
      "  prairie record examples/meadow -o wind.mp4 --duration 8 --camera close --samples 4\n"
      "  prairie record examples/meadow -o walk.mp4 --path walk.csv --size 1920x1080 --time 5\n"
      "  prairie record examples/meadow -o frames --duration 2 --fps 24 --size 640x360";
  command.run = [options](const GlobalOptions& globals) { return record(*options, globals); };
  return command;
}

}  // namespace prairie
