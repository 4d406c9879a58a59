// `prairie record`: a clip without a window, as a video or as single pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
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
#include "app/terminal/option_values.h"
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
  std::optional<double> start_s;
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
  load_asked_state(options.state, world);
  advance_to_asked_time(options.start_s, world);
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

void add_record_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command = app.add_subcommand("record", "Draws a clip, without a window");
  auto options = std::make_shared<RecordOptions>();
  command->add_option("DIR", options->folder, "The scene's folder")->required()->type_name("");
  command
      ->add_option(
          "-o,--output", options->output,
          "A video that ends in .mp4 (H.264, made by ffmpeg), or a folder for pictures frame-00000.png, …")
      ->required()
      ->type_name("FILE|FOLDER");
  CLI::Option* camera =
      command
          ->add_option("--camera", options->camera,
                       "Where it stands: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)")
          ->type_name("NAME|NUMBERS");
  command
      ->add_option(
          "--path", options->path,
          "Where it goes: lines of time_s,x_m,y_m,z_m,yaw_deg,pitch_deg[,fov_deg] after a line of these "
          "names; z as +1.7 is above the ground")
      ->type_name("FILE.csv")
      ->excludes(camera);
  command
      ->add_option_function<std::string>(
          "--duration",
          [options](const std::string& text) {
            options->duration_s = number_option("--duration", text, 0.0, kLongestS);
          },
          "Seconds (the path's, or 10)")
      ->type_name("S");
  command
      ->add_option_function<std::string>(
          "--fps",
          [options](const std::string& text) {
            options->frames_per_s = int_option("--fps", text, 1, kMostFramesPerS);
          },
          "Frames a second (30)")
      ->type_name("N");
  add_time_option(*command, options->start_s);
  add_state_options(*command, options->state);
  add_size_option(*command, options->size_px);
  add_tier_option(*command, options->tier);
  add_samples_option(*command, options->samples);
  command->footer(
      "Examples:\n"
      "  prairie record examples/meadow -o wind.mp4 --duration 8 --camera close --samples 4\n"
      "  prairie record examples/meadow -o walk.mp4 --path walk.csv --size 1920x1080 --time 5\n"
      "  prairie record examples/meadow -o frames --duration 2 --fps 24 --size 640x360");
  command->callback(
      [options, &globals, &chosen] { chosen = [options, &globals] { return record(*options, globals); }; });
}

}  // namespace prairie
