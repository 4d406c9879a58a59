// `prairie record`: a clip without a window, as a video or as single pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/outputs/clip.h"
#include "app/outputs/picture_file.h"
#include "app/outputs/recording.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/camera_path.h"
#include "app/scenes/open_world.h"
#include "app/scenes/world_time.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/progress.h"
#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

constexpr int kMostFramesPerS = 240;
constexpr int kMostFrames = 100'000;  // as many as five digits count
constexpr double kLongestS = 86400.0;
constexpr double kDefaultDurationS = 10.0;

struct RecordOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::string camera = kDefaultCamera;
  std::filesystem::path path;  // of the file of a camera's path; none: the camera stands
  std::optional<double> duration_s;
  StateOptions state;
  int frames_per_s = 30;
  glm::ivec2 size_px{1280, 720};
  Tier tier = Tier::kAuto;
  int samples = 1;
};

int frames_of(const RecordOptions& options, const std::optional<CameraPath>& path) {
  const double duration_s = options.duration_s.value_or(path ? path->times_s.back() : kDefaultDurationS);
  const double frames = std::max(std::round(duration_s * options.frames_per_s), 1.0);
  if (frames <= kMostFrames) return static_cast<int>(frames);
  throw UsageError("--duration", fmt::format("{} frames", frames), fmt::format("at most {}", kMostFrames));
}

int record(const RecordOptions& options, const GlobalOptions& globals) {
  check_picture_budget(options.size_px, globals.max_memory_bytes);
  std::optional<CameraPath> path;
  if (!options.path.empty()) path = read_camera_path(options.path);
  const int frames = frames_of(options, path);
  Clip clip({options.output, options.size_px, options.frames_per_s}, globals.threads);
  World world = open_world(options.folder, globals);
  const CameraSpec standing = path ? CameraSpec{} : camera_option(options.camera, world);
  begin_as_asked(options.state, world);
  const double start_s = world.time_s();
  Recording recording(clip,
                      {path, standing, options.size_px, options.frames_per_s, options.tier, options.samples},
                      globals, world);
  // To a frame's time, seen as in it; past the last one without being seen.
  const auto go_on_to = [&](int frame) {
    if (frame < frames) look_through(recording.camera(frame), world);
    advance_to(world, start_s + static_cast<double>(frame) / options.frames_per_s);
  };
  {
    Progress progress("frame", static_cast<std::uint64_t>(frames), globals.quiet);
    go_on_to(0);
    for (int frame = 0; frame < frames; ++frame) {
      recording.add(frame, [&] { go_on_to(frame + 1); });
      progress.advance();
    }
  }
  clip.finish();
  save_asked_state(options.state, world);
  say_done(fmt::format("{}: {} frames of {} × {} pixels, {} a second", options.output.string(), frames,
                       options.size_px.x, options.size_px.y, options.frames_per_s),
           globals.quiet);
  return kExitFine;
}

}  // namespace

Command record_command() {
  const auto options = std::make_shared<RecordOptions>();
  Command command{"record", "Draws a clip, without a window"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "-o,--output",
       .type = "FILE|FOLDER",
       .help = "A video that ends in .mp4 (H.264, made by ffmpeg), or a folder for pictures frame-00000.png, "
               "…",
       .target = text_into(options->output),
       .is_required = true},
      {.names = "--camera",
       .type = "NAME|NUMBERS",
       .help = "Where it stands: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)",
       .target = text_into(options->camera)},
      {.names = "--path",
       .type = "FILE.csv",
       .help = "Where it goes: lines of time_s,x_m,y_m,z_m,yaw_deg,pitch_deg[,fov_deg] after a line of these "
               "names; z as +1.7 is above the ground",
       .target = text_into(options->path),
       .excludes = {"--camera"}},
      {.names = "--duration",
       .type = "S",
       .help = "Seconds (the path's, or 10)",
       .target = number_into(options->duration_s, 0.0, kLongestS)},
      {.names = "--fps",
       .type = "N",
       .help = "Frames a second (30)",
       .target = whole_number_into(options->frames_per_s, 1, kMostFramesPerS)},
      time_option(options->state),
      load_state_option(options->state),
      save_state_option(options->state),
      picture_size_option(options->size_px),
      picture_tier_option(options->tier),
      picture_samples_option(options->samples),
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
