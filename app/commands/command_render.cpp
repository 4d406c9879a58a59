// `prairie render`: one picture without a window.
#include <fmt/format.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/replay_options.h"
#include "app/commands/scene_options.h"
#include "app/commands/state_options.h"
#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/installed_files.h"
#include "app/scenes/open_world.h"
#include "app/scenes/world_time.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"
#include "world/world.h"

namespace prairie {
namespace {

struct RenderOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::string camera = kDefaultCamera;
  glm::ivec2 size_px{1280, 720};
  std::optional<double> parallel_height_m;
  Tier tier = Tier::kAuto;
  std::optional<glm::dvec3> lod_eye_m;
  bool tier_tint = false;
  int samples = 1;
  ReplayOptions replay;
  StateOptions state;
};

int render_picture(const RenderOptions& options, const GlobalOptions& globals) {
  const PictureFormat format = picture_format(options.output);
  check_picture_budget(options.size_px, globals.max_memory_bytes);
  check_output_file(options.output);
  World world = open_world(options.folder, globals);
  Camera camera = placed_camera(camera_option(options.camera, world), world, options.size_px);
  camera.orthographic_height_m = options.parallel_height_m.value_or(0.0);

  replay_as_asked(options.replay, globals, world);
  begin_as_asked(options.state, world);
  save_asked_state(options.state, world);
  world.watch_anew(watched_place_m(camera, world.meadow().ground));
  const HeadlessContext context(globals.device);
  Renderer renderer(world, shader_folder());
  FrameOptions frame;
  frame.tier = options.tier;
  frame.lod_eye_m = options.lod_eye_m;
  frame.tier_tint = options.tier_tint;
  frame.memory_budget_bytes = globals.max_memory_bytes;
  const Picture picture = renderer.render(camera, frame, options.samples);
  write_output(options.output, encoded_picture(picture, format));
  say_done(fmt::format("{}: {} × {} pixels, {} blades drawn", options.output.string(), picture.width,
                       picture.height, renderer.picture_statistics().blades_drawn),
           globals.quiet);
  return kExitFine;
}

}  // namespace

Command render_command() {
  const auto options = std::make_shared<RenderOptions>();
  Command command{"render", "Draws one picture, without a window"};
  command.options = {
      scene_folder_option(options->folder),
      {.names = "-o,--output",
       .type = "FILE",
       .help = "The picture: .png (8-bit sRGB) or .exr (linear float)",
       .target = text_into(options->output),
       .is_required = true},
      {.names = "--camera",
       .type = "NAME|NUMBERS",
       .help =
           "A camera of the scene, or x,y,z,yaw,pitch[,fov] in metres and degrees; z as +1.7 is above the "
           "ground, yaw 0 looks north and turns clockwise, fov is vertical (default)",
       .target = text_into(options->camera)},
      picture_size_option(options->size_px),
      parallel_option(options->parallel_height_m),
      picture_tier_option(options->tier),
      lod_eye_option(options->lod_eye_m, "the camera's"),
      picture_samples_option(options->samples),
      replay_option(options->replay),
      replay_at_option(options->replay),
      replay_fps_option(options->replay),
      time_option(options->state),
      load_state_option(options->state),
      save_state_option(options->state),
      {.names = "--tint",
       .help = "Colour tiers: spline blades red, Hermite blades yellow, strips green, flat blue",
       .target = &options->tier_tint},
  };
  command.footer =
      "Examples:\n"
      "  prairie render examples/meadow -o meadow.png\n"
      "  prairie render examples/meadow -o low.png --camera 40,20,+0.5,30,-5 --size 1920x1080 --samples 8\n"
      "  prairie render examples/meadow -o linear.exr --tier flat --set sun.elevation_deg=12\n"
      "  prairie render examples/meadow -o later.png --time 20 --save-state at20.state";
  command.run = [options](const GlobalOptions& globals) { return render_picture(*options, globals); };
  return command;
}

}  // namespace prairie
