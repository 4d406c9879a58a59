// `prairie view`: the command line of app/viewer/view.h.
#include <memory>
#include <string>

#include "app/commands/commands.h"
#include "app/scenes/camera_option.h"
#include "app/scenes/open_world.h"
#include "app/terminal/exit_code.h"
#include "app/terminal/option_values.h"
#include "app/viewer/actions.h"
#include "app/viewer/key_help.h"
#include "app/viewer/view.h"

namespace prairie {
namespace {

constexpr int kMostFrames = 1'000'000;

struct ViewCommandOptions {
  std::filesystem::path folder;
  std::string camera = kDefaultCamera;
  glm::ivec2 size_px{1280, 720};
  ViewerOptions viewer;
};

int view(const ViewCommandOptions& options, const GlobalOptions& globals) {
  World world = open_world(options.folder, globals);
  const Camera start = placed_camera(camera_option(options.camera, world), world, options.size_px);
  ViewerOptions viewer = options.viewer;
  viewer.memory_budget_bytes = globals.max_memory_bytes;
  view_world(world, start, viewer);
  return kExitFine;
}

}  // namespace

void add_view_command(CLI::App& app, const GlobalOptions& globals, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "view", "Opens a window to fly over the moving meadow, walk through it and play with it");
  auto options = std::make_shared<ViewCommandOptions>();
  command->add_option("DIR", options->folder, "The scene's folder")->required()->type_name("");
  command
      ->add_option("--camera", options->camera,
                   "Where to start: a camera of the scene, or x,y,z,yaw,pitch[,fov] (default)")
      ->type_name("NAME|NUMBERS");
  command
      ->add_option_function<std::string>(
          "--size", [options](const std::string& text) { options->size_px = size_option("--size", text); },
          "The window's pixels at first (1280x720)")
      ->type_name("WxH");
  command
      ->add_option_function<std::string>(
          "--tier",
          [options](const std::string& text) { options->viewer.tier = tier_option("--tier", text); },
          "How grass is drawn: auto, spline, hermite, strip or flat (auto)")
      ->type_name("TIER");
  command->add_flag("--msaa", options->viewer.msaa, "Smooth edges with 4 samples per pixel");
  command->add_flag("--paused", options->viewer.paused, "Time stands still at first; P lets it go on");
  // For tests, and for whoever wants a picture of what the window shows.
  command
      ->add_option_function<std::string>(
          "--frames",
          [options](const std::string& text) {
            options->viewer.frames = int_option("--frames", text, 1, kMostFrames);
          },
          "Close after so many frames")
      ->group("");
  command->add_option("--screenshot", options->viewer.screenshot, "Save the last picture")->group("");
  command->footer("Keys:\n" + key_table(viewer_actions()) +
                  "Examples:\n"
                  "  prairie view examples/meadow\n"
                  "  prairie view examples/meadow --camera 64,64,+12,0,-20 --size 1920x1080");
  command->callback(
      [options, &globals, &chosen] { chosen = [options, &globals] { return view(*options, globals); }; });
}

}  // namespace prairie
