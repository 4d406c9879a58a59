// `prairie walk`: a scene's walkers, in a window or without one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "agents/gait_of_bvh.h"
#include "agents/track_files.h"
#include "agents/utm.h"
#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/commands/window_options.h"
#include "app/outputs/clip.h"
#include "app/outputs/picture_file.h"
#include "app/outputs/recording.h"
#include "app/outputs/streamed_output.h"
#include "app/outputs/trajectory_table.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/camera_path.h"
#include "app/scenes/open_world.h"
#include "app/scenes/world_time.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "app/terminal/progress.h"
#include "app/terminal/usage_error.h"
#include "app/viewer/view.h"

namespace prairie {
namespace {

constexpr double kLongestS = 86400.0;
constexpr double kDefaultDurationS = 10.0;
constexpr int kMostStepsPerS = 240;
constexpr double kFarthestM = 1e6;

struct ReplayPlace {
  glm::dvec2 position_m{0.0};
  double turn_rad = 0.0;  // counter-clockwise
};

struct WalkOptions {
  std::filesystem::path folder;
  std::optional<double> duration_s;
  std::filesystem::path record, trajectories, replay, gait, path;
  std::optional<ReplayPlace> replay_at;
  std::optional<std::string> camera;
  StateOptions state;
  int frames_per_s = 30;
  glm::ivec2 size_px{1280, 720};
  Tier tier = Tier::kAuto;
  int samples = 1;
  ViewerOptions viewer;

  std::string camera_or_default() const { return camera.value_or(kDefaultCamera); }
  bool is_headless() const { return duration_s || !record.empty() || !trajectories.empty() || state.save; }
};

ReplayPlace replay_place_option(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3)
    throw UsageError(option, text, "x,y[,deg]: metres, and degrees clockwise");
  ReplayPlace place;
  place.position_m = {number_option(option, parts[0], -kFarthestM, kFarthestM),
                      number_option(option, parts[1], -kFarthestM, kFarthestM)};
  if (parts.size() == 3)
    place.turn_rad = -number_option(option, parts[2], -360.0, 360.0) * std::numbers::pi / 180.0;
  return place;
}

/// Tracks lie where their file says; of GPX without a georeferenced ground the first point lies in the
/// middle.
void replay(const WalkOptions& options, World& world) {
  std::optional<UtmFrame> frame;
  if (world.geo_reference()) frame = utm_frame_of(*world.geo_reference());
  std::vector<Track> tracks = read_tracks(options.replay, "--replay", frame);
  ReplayPlace place = options.replay_at.value_or(ReplayPlace{});
  const bool is_gpx = options.replay.extension() == ".gpx" || options.replay.extension() == ".GPX";
  if (!options.replay_at && is_gpx && !frame) place.position_m = 0.5 * world.meadow().extent_m;
  world.replay(placed(std::move(tracks), place.position_m, place.turn_rad));
}

double duration_s(const WalkOptions& options, const World& world, const std::optional<CameraPath>& path) {
  if (options.duration_s) return *options.duration_s;
  if (path) return path->times_s.back();
  return world.replayed() ? std::max(world.replayed()->last_s() - world.time_s(), 0.0) : kDefaultDurationS;
}

int walk_headless(const WalkOptions& options, const GlobalOptions& globals, World& world) {
  std::optional<CameraPath> path;
  if (!options.path.empty()) path = read_camera_path(options.path);
  std::optional<Clip> clip;
  if (!options.record.empty()) {
    check_picture_budget(options.size_px, globals.max_memory_bytes);
    clip.emplace(ClipFormat{options.record, options.size_px, options.frames_per_s}, globals.threads);
  }
  begin_as_asked(options.state, world);
  const double start_s = world.time_s();
  const double frames_asked =
      std::max(std::round(duration_s(options, world, path) * options.frames_per_s), 1.0);
  const int frames = static_cast<int>(frames_asked);
  std::optional<Recording> recording;
  if (clip) {
    const CameraSpec standing = path ? CameraSpec{} : camera_option(options.camera_or_default(), world);
    recording.emplace(
        *clip, ClipView{path, standing, options.size_px, options.frames_per_s, options.tier, options.samples},
        globals, world);
  }
  std::optional<StreamedOutput> table;
  if (!options.trajectories.empty()) table.emplace(options.trajectories);
  if (table) table->write(trajectory_header());
  // To a frame's time, seen and told as in it; past the last one neither.
  const auto go_on_to = [&](int frame) {
    if (frame < frames && recording) look_through(recording->camera(frame), world);
    advance_to(world, start_s + static_cast<double>(frame) / options.frames_per_s);
    if (frame < frames && table) table->write(trajectory_rows(world));
  };
  {
    Progress progress("step", static_cast<std::uint64_t>(frames), globals.quiet);
    go_on_to(0);
    for (int frame = 0; frame < frames; ++frame) {
      const auto go_on = [&] { go_on_to(frame + 1); };
      if (recording) {
        recording->add(frame, go_on);
      } else {
        go_on();
      }
      progress.advance();
    }
  }
  if (clip) clip->finish();
  if (table) table->finish();
  save_asked_state(options.state, world);
  say_done(fmt::format("{} walkers went on to {:.2f} s", world.walkers().size(), world.time_s()),
           globals.quiet);
  return kExitFine;
}

int walk(const WalkOptions& options, const GlobalOptions& globals) {
  std::optional<Gait> gait;
  if (!options.gait.empty()) gait = gait_of(read_bvh(options.gait, "--gait"));
  World world = open_world(options.folder, globals, gait);
  if (!options.replay.empty()) replay(options, world);
  if (world.walkers().empty())
    throw BadInput((options.folder / kSceneFileName).string(), "walkers", "nobody who walks",
                   "a [[walkers]] group, or --replay");
  if (options.is_headless()) return walk_headless(options, globals, world);
  begin_as_asked(options.state, world);
  ViewerOptions viewer = options.viewer;
  // Whoever asks for a camera looks through it; else the first walker is followed.
  if (!options.camera) viewer.follow = 0;
  viewer.walker_overlay = true;
  viewer.tier = options.tier;
  viewer.memory_budget_bytes = globals.max_memory_bytes;
  view_world(world, placed_camera(camera_option(options.camera_or_default(), world), world, options.size_px),
             viewer);
  return kExitFine;
}

}  // namespace

Command walk_command() {
  const auto options = std::make_shared<WalkOptions>();
  Command command{"walk",
                  "Lets a scene's walkers walk, in a window or, with --duration and the like, without"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "--duration",
       .type = "S",
       .help = "Without a window, for so many seconds (10, the path's, or all of the tracks)",
       .target = number_into(options->duration_s, 0.0, kLongestS)},
      {.names = "--trajectories",
       .type = "FILE.csv",
       .help = "Write where everybody is, each 1/fps s; - is stdout",
       .target = text_into(options->trajectories)},
      {.names = "--record",
       .type = "FILE|FOLDER",
       .help = "Draw a clip without a window: a video that ends in .mp4, or a folder of pictures",
       .target = text_into(options->record)},
      {.names = "--replay",
       .type = "FILE",
       .help = "Walkers go along recorded tracks instead: CSV (time_s,id,x_m,y_m), UCY obsmat.txt or GPX",
       .target = text_into(options->replay)},
      {.names = "--replay-at",
       .type = "x,y[,deg]",
       .help = "Where the tracks' (0, 0) lies in the scene, and how far they are turned, clockwise",
       .target = parsed_into(options->replay_at, replay_place_option),
       .needs = {"--replay"}},
      {.names = "--gait",
       .type = "FILE.bvh",
       .help = "Walk as in this recorded motion",
       .target = text_into(options->gait)},
      {.names = "--camera",
       .type = "NAME|NUMBERS",
       .help = "Where it stands: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)",
       .target = text_into(options->camera)},
      {.names = "--path",
       .type = "FILE.csv",
       .help = "Where the clip's camera goes, as for record",
       .target = text_into(options->path),
       .needs = {"--record"},
       .excludes = {"--camera"}},
      {.names = "--fps",
       .type = "N",
       .help = "Frames, and lines of each walker, a second (30)",
       .target = whole_number_into(options->frames_per_s, 1, kMostStepsPerS)},
      time_option(options->state),
      load_state_option(options->state),
      save_state_option(options->state),
      picture_size_option(options->size_px),
      picture_tier_option(options->tier),
      picture_samples_option(options->samples),
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
