// `prairie render`: one picture without a window.
#include <fmt/format.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/commands/picture_options.h"
#include "app/commands/state_options.h"
#include "app/outputs/outputs.h"
#include "app/outputs/picture_file.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/installed_files.h"
#include "app/scenes/open_world.h"
#include "app/scenes/world_time.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/messages.h"
#include "app/terminal/option_values.h"
#include "render/frame/renderer.h"
#include "render/gl/context.h"

namespace prairie {
namespace {

struct RenderOptions {
  std::filesystem::path folder;
  std::filesystem::path output;
  std::string camera = kDefaultCamera;
  glm::ivec2 size_px{1280, 720};
  Tier tier = Tier::kAuto;
  std::optional<glm::dvec3> lod_eye_m;
  bool tier_tint = false;
  int samples = 1;
  std::optional<double> time_s;
  StateOptions state;
};

int render_picture(const RenderOptions& options, const GlobalOptions& globals) {
  const PictureFormat format = picture_format(options.output);
  check_picture_budget(options.size_px, globals.max_memory_bytes);
  check_output_file(options.output);
  World world = open_world(options.folder, globals);
  const Camera camera = placed_camera(camera_option(options.camera, world), world, options.size_px);

  load_asked_state(options.state, world);
  advance_to_asked_time(options.time_s, world);
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

void add_render_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command = app.add_subcommand("render", "Draws one picture, without a window");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("DIR", options->folder, "The scene's folder")->required()->type_name("");
  command->add_option("-o,--output", options->output, "The picture: .png (8-bit sRGB) or .exr (linear float)")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--camera", options->camera,
          "A camera of the scene, or x,y,z,yaw,pitch[,fov] in metres and degrees; z as +1.7 is above the "
          "ground, yaw 0 looks north and turns clockwise, fov is vertical (default)")
      ->type_name("NAME|NUMBERS");
  add_size_option(*command, options->size_px);
  add_tier_option(*command, options->tier);
  command
      ->add_option_function<std::string>(
          "--lod-eye",
          [options](const std::string& text) { options->lod_eye_m = place_option("--lod-eye", text); },
          "Tiers are chosen for an eye there, in metres (the camera's)")
      ->type_name("X,Y,Z");
  add_samples_option(*command, options->samples);
  add_time_option(*command, options->time_s);
  add_state_options(*command, options->state);
  command->add_flag("--tint", options->tier_tint,
                    "Colour tiers: spline blades red, Hermite blades yellow, strips green, flat blue");
  command->footer(
      "Examples:\n"
      "  prairie render examples/meadow -o meadow.png\n"
      "  prairie render examples/meadow -o low.png --camera 40,20,+0.5,30,-5 --size 1920x1080 --samples 8\n"
      "  prairie render examples/meadow -o linear.exr --tier flat --set sun.elevation_deg=12\n"
      "  prairie render examples/meadow -o later.png --time 20 --save-state at20.state");
  command->callback([options, &globals, &chosen] {
    chosen = [options, &globals] { return render_picture(*options, globals); };
  });
}

}  // namespace prairie
